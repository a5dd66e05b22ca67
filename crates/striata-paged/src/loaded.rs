//! Pages that have been read, with the vertices to which their imports refer.

use std::collections::HashMap;

use crate::hash::IndexHash;
use crate::{Page, PagedError};

/// A vertex of a loaded page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct VertexPlace {
    /// Place of the page in the list of loaded pages.
    pub slot: u32,
    /// Number of the vertex among those that the page owns.
    pub vertex: u32,
}

/// Loaded pages, coarse to fine, each with its index in the directory; all parents are among them.
pub(crate) struct LoadedPages<'a> {
    pages: Vec<(u32, &'a Page)>,
    /// Number of the first vertex of each page in a common numbering, then the number of all vertices.
    first_vertex: Vec<u32>,
    /// Page and number of each vertex that a page imports, by page.
    imports: Vec<Vec<VertexPlace>>,
}

impl<'a> LoadedPages<'a> {
    /// Finds what all imports refer to.
    ///
    /// # Errors
    /// [`PagedError::Mismatch`] if a parent of a page is absent, is not coarser, or has fewer vertices than are imported.
    pub(crate) fn new(pages: &[(u32, &'a Page)]) -> Result<Self, PagedError> {
        let mut pages = pages.to_vec();
        pages.sort_by_key(|&(index, _)| index);
        if let Some(pair) = pages.windows(2).find(|pair| pair[0].1.id.level < pair[1].1.id.level) {
            let reason = "it is listed after finer pages";
            return Err(PagedError::Mismatch { id: pair[1].1.id, reason });
        }
        let slot_of: HashMap<u32, u32, IndexHash> =
            pages.iter().zip(0..).map(|(&(index, _), slot)| (index, slot)).collect();
        let mut first_vertex = vec![0u32];
        for &(_, page) in &pages {
            let last = first_vertex.last().copied().unwrap_or(0);
            let next = last.checked_add(page.positions.len() as u32);
            let reason = "there are more vertices than can be numbered";
            first_vertex.push(next.ok_or(PagedError::Mismatch { id: page.id, reason })?);
        }
        let mut imports = Vec::with_capacity(pages.len());
        for &(_, page) in &pages {
            let places = page.imports.iter().map(|import| {
                let owner = slot_of.get(&import.page).copied();
                let has_vertex = |slot: &u32| {
                    let owner = pages[*slot as usize].1;
                    owner.id.level > page.id.level && (import.vertex as usize) < owner.positions.len()
                };
                let reason = "a vertex that it imports is in no coarser page";
                match owner.filter(has_vertex) {
                    Some(slot) => Ok(VertexPlace { slot, vertex: import.vertex }),
                    None => Err(PagedError::Mismatch { id: page.id, reason }),
                }
            });
            imports.push(places.collect::<Result<Vec<VertexPlace>, PagedError>>()?);
        }
        Ok(Self { pages, first_vertex, imports })
    }

    /// Number of pages.
    pub(crate) fn len(&self) -> usize {
        self.pages.len()
    }

    /// A page.
    pub(crate) fn page(&self, slot: u32) -> &'a Page {
        self.pages[slot as usize].1
    }

    /// Index of a page in the directory.
    pub(crate) fn index_of(&self, slot: u32) -> u32 {
        self.pages[slot as usize].0
    }

    /// All pages, coarse to fine.
    pub(crate) fn pages(&self) -> impl Iterator<Item = &'a Page> {
        self.pages.iter().map(|&(_, page)| page)
    }

    /// Page and number of each vertex that a page imports.
    pub(crate) fn imports_of(&self, slot: u32) -> &[VertexPlace] {
        &self.imports[slot as usize]
    }

    /// Number of a vertex in the numbering of all loaded pages, in which coarse pages come first.
    pub(crate) fn number(&self, place: VertexPlace) -> u32 {
        self.first_vertex[place.slot as usize] + place.vertex
    }

    /// Number of all vertices.
    pub(crate) fn vertex_count(&self) -> usize {
        self.first_vertex.last().copied().unwrap_or(0) as usize
    }

    /// The vertex with a number.
    pub(crate) fn place(&self, number: u32) -> VertexPlace {
        let slot = self.first_vertex.partition_point(|&first| first <= number) as u32 - 1;
        VertexPlace { slot, vertex: number - self.first_vertex[slot as usize] }
    }

    /// Number of a vertex as a page numbers it: owned vertices, then imports.
    pub(crate) fn number_in(&self, slot: u32, v: u32) -> u32 {
        match (v as usize).checked_sub(self.page(slot).positions.len()) {
            Some(import) => self.number(self.imports[slot as usize][import]),
            None => self.first_vertex[slot as usize] + v,
        }
    }

    /// Slots of pages of the same level, from fine to coarse. They do not depend on each other.
    pub(crate) fn levels(&self) -> Vec<std::ops::Range<u32>> {
        let mut levels = Vec::new();
        let mut end = self.pages.len() as u32;
        for run in self.pages.chunk_by(|a, b| a.1.id.level == b.1.id.level).rev() {
            levels.push(end - run.len() as u32..end);
            end -= run.len() as u32;
        }
        levels
    }
}

/// The import to which each owned vertex has collapsed when all steps of its page are undone, numbered as in the page.
/// The base page has no steps, so its vertices stay.
pub(crate) fn coarse_vertices(page: &Page) -> Vec<u32> {
    let owned = page.positions.len() as u32;
    if page.targets.is_empty() {
        return (0..owned).collect();
    }
    let mut coarse: Vec<u32> = page.targets.clone();
    for v in 0..coarse.len() {
        // Targets have larger keys, so the loop terminates.
        let mut at = coarse[v];
        while at < owned {
            at = coarse[at as usize];
        }
        coarse[v] = at;
    }
    coarse
}
