//! The encode task: finds the pages that own the imports of each page, and writes the pages' bytes.

use std::collections::HashMap;
use std::rc::Rc;

use striata::mesh::AttributeLayer;

use super::PagedBuildError;
use super::part_file::{PartIndex, PartWriter};
use super::plan::{BuildTask, PagedPlan, TaskKind};
use super::simplify_task::base_page;
use super::wire::{PendingPage, WireReader};
use crate::{Import, PageEntry, PageId};

/// Tables of owned vertices that a task keeps at once.
const MAX_OWNERS: usize = 200;

/// Inputs that encode tasks share.
pub(super) struct EncodeInputs {
    /// Steps of all cells.
    steps: PartIndex,
    /// Triangles that no cell has removed.
    triangles: PartIndex,
    /// All pages in directory order: the base page, then levels from coarse to fine.
    order: Vec<PageId>,
}

impl EncodeInputs {
    pub(super) fn open(plan: &PagedPlan) -> Result<Self, PagedBuildError> {
        let mut steps = Vec::new();
        let mut triangles = Vec::new();
        for task in &plan.tasks {
            if let TaskKind::Level(level) = task.kind {
                steps.push(plan.steps_path(level, task.first));
            }
            if matches!(task.kind, TaskKind::Level(_) | TaskKind::Sort) {
                triangles.push(plan.triangles_path(task));
            }
        }
        let steps = PartIndex::open(steps.into_iter())?;
        let mut order: Vec<PageId> = steps.ids().collect();
        order.push(PageId { level: plan.level_count(), cell: 0 });
        order.sort_by_key(|id| (u8::MAX - id.level, id.cell));
        Ok(Self { steps, triangles: PartIndex::open(triangles.into_iter())?, order })
    }

    /// Number of a page in the directory.
    fn index_of(&self, id: PageId) -> Option<u32> {
        let found = self
            .order
            .binary_search_by_key(&(u8::MAX - id.level, id.cell), |id| (u8::MAX - id.level, id.cell));
        found.ok().map(|index| index as u32)
    }

    /// Reads a page without its imports; `None` if the cell has no steps.
    fn page(&self, plan: &PagedPlan, id: PageId) -> Result<Option<PendingPage>, PagedBuildError> {
        if id.level == plan.level_count() {
            return base_page(plan, &self.triangles).map(Some);
        }
        let Some((part, segment)) = self.steps.find(id).next() else { return Ok(None) };
        let bytes = part.read(segment)?;
        WireReader::new(&bytes, &plan.metadata.empty_mesh())
            .steps(id)
            .map(Some)
            .map_err(|error| part.named(error))
    }
}

/// Owned vertices of a page by position.
struct Owner {
    page: PendingPage,
    position_of: HashMap<[u32; 3], u32>,
}

impl Owner {
    fn new(page: PendingPage) -> Self {
        let first = &page.page.first;
        let numbers = first[..first.len() - 1].iter().enumerate();
        let position_of =
            numbers.map(|(p, &v)| (page.page.positions[v as usize].map(f32::to_bits), p as u32)).collect();
        Self { page, position_of }
    }

    /// The owned vertex that equals vertex `v` of `others`.
    fn find(&self, position: [f32; 3], others: &[AttributeLayer], v: u32) -> Option<u32> {
        let p = *self.position_of.get(&position.map(f32::to_bits))? as usize;
        let wedges = self.page.page.first[p]..self.page.page.first[p + 1];
        let bytes = |layer: &AttributeLayer, v: u32| {
            let n = layer.vertex_bytes();
            layer.data.as_bytes()[v as usize * n..][..n].to_vec()
        };
        wedges.into_iter().find(|&w| {
            let mut layers = self.page.page.layers.iter().zip(others);
            layers.all(|(own, other)| bytes(own, w) == bytes(other, v))
        })
    }
}

/// Owners read so far.
struct Owners<'a> {
    plan: &'a PagedPlan,
    inputs: &'a EncodeInputs,
    known: HashMap<PageId, Option<Rc<Owner>>>,
}

impl Owners<'_> {
    fn get(&mut self, id: PageId) -> Result<Option<Rc<Owner>>, PagedBuildError> {
        if let Some(known) = self.known.get(&id) {
            return Ok(known.clone());
        }
        if self.known.len() >= MAX_OWNERS {
            self.known.clear();
        }
        let owner = self.inputs.page(self.plan, id)?.map(|page| Rc::new(Owner::new(page)));
        self.known.insert(id, owner.clone());
        Ok(owner)
    }

    /// The page and vertex that own vertex `v` of a page's others.
    fn import(&mut self, page: &PendingPage, v: u32) -> Result<Import, PagedBuildError> {
        let id = page.page.id;
        let partition = self.plan.partition()?;
        let position = page.others[v as usize];
        let level_count = self.plan.level_count();
        for level in id.level + 1..=level_count {
            let cell = match partition.levels().get(level as usize) {
                Some(cells) => cells.cell_of(position),
                None => 0,
            };
            let owner_id = PageId { level, cell };
            let Some(owner) = self.get(owner_id)? else { continue };
            if let Some(vertex) = owner.find(position, &page.other_layers, v)
                && let Some(index) = self.inputs.index_of(owner_id)
            {
                return Ok(Import { page: index, vertex });
            }
        }
        Err(PagedBuildError::NoOwner { id })
    }
}

/// Runs an encode task. Each segment has the length of the page's entry, the entry as JSON, and the page.
pub(super) fn run(plan: &PagedPlan, task: &BuildTask, inputs: &EncodeInputs) -> Result<(), PagedBuildError> {
    let TaskKind::Encode(level) = task.kind else { return Ok(()) };
    let mut owners = Owners { plan, inputs, known: HashMap::new() };
    let mut writer = PartWriter::create(&plan.pages_path(level, task.first))?;
    for cell in task.first..task.first + task.count {
        let id = PageId { level, cell: cell as u32 };
        let Some(mut pending) = inputs.page(plan, id)? else { continue };
        let imports: Result<Vec<Import>, PagedBuildError> =
            (0..pending.others.len() as u32).map(|v| owners.import(&pending, v)).collect();
        pending.page.imports = imports?;
        let bytes = pending.page.to_bytes(&plan.metadata);
        let entry = serde_json::to_vec(&PageEntry::new(&pending.page, &bytes, 0)).unwrap_or_default();
        let segment = [&(entry.len() as u32).to_le_bytes(), entry.as_slice(), &bytes].concat();
        writer.write(id, &segment)?;
    }
    writer.finish()
}
