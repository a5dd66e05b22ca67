//! Files that use each other, directly or through others. They can only be understood, tested and moved together, so
//! they are one file, or have a part that belongs elsewhere.
//!
//! A file uses another one if it imports an item that the other one defines. Items that a module only passes on count
//! for the file that defines them.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use anyhow::Result;
use petgraph::algo::tarjan_scc;
use petgraph::graphmap::DiGraphMap;
use syn::visit::{self, Visit};
use syn::{Item, UseTree, Visibility};

use super::CountWithPlaces;
use super::sources::{RustFile, RustFiles, is_for_tests};

/// How many times an item may be passed on from module to module.
const MOST_STEPS: usize = 16;

/// Finds the circles of files outside of tests.
pub(super) fn circles(sources: &RustFiles) -> Result<CountWithPlaces> {
    let mut crates: BTreeMap<String, Vec<&RustFile>> = BTreeMap::new();
    for source in &sources.files {
        if let Some((package, _)) = place_of(&source.path) {
            crates.entry(package).or_default().push(source);
        }
    }
    let mut found = Vec::new();
    for files in crates.values() {
        let modules = Modules::new(files);
        let mut graph = DiGraphMap::<usize, BTreeSet<&str>>::new();
        for file in 0..files.len() {
            graph.add_node(file);
            for (other, names) in modules.used_by(file) {
                graph.add_edge(file, other, names);
            }
        }
        let path = |file: usize| files[file].path.display();
        for mut circle in tarjan_scc(&graph).into_iter().filter(|circle| circle.len() > 1) {
            circle.sort_unstable();
            let mut text = circle.iter().map(|&file| path(file).to_string()).collect::<Vec<_>>().join(", ");
            for (from, to) in circle.iter().flat_map(|&from| circle.iter().map(move |&to| (from, to))) {
                if let Some(names) = graph.edge_weight(from, to) {
                    let names: Vec<&str> = names.iter().copied().collect();
                    text.push_str(&format!("\n    {} -> {}: {}", path(from), path(to), names.join(", ")));
                }
            }
            found.push(text);
        }
    }
    found.sort();
    Ok(found.into())
}

/// Returns the package of a file within `src`, and the module that it is.
fn place_of(path: &Path) -> Option<(String, Vec<String>)> {
    let parts: Vec<&str> = path.to_str()?.split('/').collect();
    let src = parts.iter().position(|&part| part == "src")?;
    let (last, folders) = parts[src + 1..].split_last()?;
    let mut module: Vec<String> = folders.iter().map(|&folder| folder.to_owned()).collect();
    match last.strip_suffix(".rs")? {
        "lib" | "main" if folders.is_empty() => {}
        "mod" => {}
        name => module.push(name.to_owned()),
    }
    Some((parts[..src].join("/"), module))
}

/// The modules of a package.
struct Modules {
    /// File of each module.
    files: BTreeMap<Vec<String>, usize>,
    /// By file.
    contents: Vec<NamesOfFile>,
}

/// Names that a file defines and imports.
#[derive(Default)]
struct NamesOfFile {
    module: Vec<String>,
    defined: BTreeSet<String>,
    /// Names that the file imports or passes on, with their paths.
    imported: BTreeMap<String, Vec<String>>,
    /// Paths of modules all of whose names are imported.
    globs: Vec<Vec<String>>,
    /// Paths that the file imports for itself.
    paths: BTreeSet<Vec<String>>,
}

impl Modules {
    fn new(sources: &[&RustFile]) -> Self {
        let mut files = BTreeMap::new();
        let mut contents = Vec::with_capacity(sources.len());
        for (number, source) in sources.iter().enumerate() {
            let module = place_of(&source.path).map_or_else(Vec::new, |(_, module)| module);
            files.entry(module.clone()).or_insert(number);
            let mut content = NamesOfFile { module, ..NamesOfFile::default() };
            content.visit_file(&source.syntax);
            contents.push(content);
        }
        Self { files, contents }
    }

    /// Other files that define what a file imports, and the names of that.
    fn used_by(&self, file: usize) -> BTreeMap<usize, BTreeSet<&str>> {
        let mut used: BTreeMap<usize, BTreeSet<&str>> = BTreeMap::new();
        for path in &self.contents[file].paths {
            let other = self.defining_file(file, path, MOST_STEPS).filter(|&other| other != file);
            if let (Some(other), Some(name)) = (other, path.last()) {
                used.entry(other).or_default().insert(name);
            }
        }
        used
    }

    /// The file that defines what a path in a file leads to; `None` if that is outside of the package.
    fn defining_file(&self, from: usize, path: &[String], steps: usize) -> Option<usize> {
        let content = &self.contents[from];
        let mut module = content.module.clone();
        let mut rest = path;
        let mut is_absolute = false;
        while let [first, more @ ..] = rest {
            match first.as_str() {
                "crate" => module.clear(),
                "self" => {}
                "super" => drop(module.pop()),
                _ => break,
            }
            (rest, is_absolute) = (more, true);
        }
        let mut at = if is_absolute { *self.files.get(&module)? } else { from };
        for (place, name) in rest.iter().enumerate() {
            let mut child = module.clone();
            child.push(name.clone());
            if let Some(&file) = self.files.get(&child) {
                (module, at) = (child, file);
                continue;
            }
            let content = &self.contents[at];
            if content.defined.contains(name) {
                return Some(at);
            }
            let further = steps.checked_sub(1)?;
            if let Some(import) = content.imported.get(name) {
                let whole: Vec<String> = import.iter().chain(&rest[place + 1..]).cloned().collect();
                return self.defining_file(at, &whole, further);
            }
            let through = |glob: &Vec<String>| {
                let whole: Vec<String> = glob.iter().chain(&rest[place..]).cloned().collect();
                self.defining_file(at, &whole, further)
            };
            return content.globs.iter().find_map(through);
        }
        (!rest.is_empty()).then_some(at)
    }
}

impl NamesOfFile {
    /// Records the names of an import.
    fn import(&mut self, tree: &UseTree, prefix: &mut Vec<String>, is_passed_on: bool) {
        match tree {
            UseTree::Path(path) => {
                prefix.push(path.ident.to_string());
                self.import(&path.tree, prefix, is_passed_on);
                prefix.pop();
            }
            UseTree::Group(group) => {
                group.items.iter().for_each(|item| self.import(item, prefix, is_passed_on))
            }
            UseTree::Glob(_) => self.globs.push(prefix.clone()),
            UseTree::Name(name) => {
                self.import_name(&name.ident.to_string(), &name.ident.to_string(), prefix, is_passed_on)
            }
            UseTree::Rename(name) => {
                self.import_name(&name.ident.to_string(), &name.rename.to_string(), prefix, is_passed_on);
            }
        }
    }

    fn import_name(&mut self, name: &str, as_name: &str, prefix: &[String], is_passed_on: bool) {
        let mut path = prefix.to_vec();
        if name != "self" {
            path.push(name.to_owned());
        }
        let as_name =
            if as_name == "self" { path.last().cloned().unwrap_or_default() } else { as_name.to_owned() };
        if !is_passed_on {
            self.paths.insert(path.clone());
        }
        // A name can stand for itself, as in `use foo;`.
        if path != [as_name.clone()] {
            self.imported.insert(as_name, path);
        }
    }
}

impl<'ast> Visit<'ast> for NamesOfFile {
    fn visit_item(&mut self, item: &'ast Item) {
        let (attributes, name) = match item {
            Item::Const(item) => (&item.attrs, Some(&item.ident)),
            Item::Enum(item) => (&item.attrs, Some(&item.ident)),
            Item::Fn(item) => (&item.attrs, Some(&item.sig.ident)),
            Item::Mod(item) => (&item.attrs, item.content.is_some().then_some(&item.ident)),
            Item::Static(item) => (&item.attrs, Some(&item.ident)),
            Item::Struct(item) => (&item.attrs, Some(&item.ident)),
            Item::Trait(item) => (&item.attrs, Some(&item.ident)),
            Item::Type(item) => (&item.attrs, Some(&item.ident)),
            Item::Union(item) => (&item.attrs, Some(&item.ident)),
            Item::Impl(item) => (&item.attrs, None),
            Item::Use(item) => {
                if !is_for_tests(&item.attrs) {
                    let is_passed_on = !matches!(item.vis, Visibility::Inherited);
                    self.import(&item.tree, &mut Vec::new(), is_passed_on);
                }
                return;
            }
            _ => return visit::visit_item(self, item),
        };
        if !is_for_tests(attributes) {
            self.defined.extend(name.map(ToString::to_string));
            visit::visit_item(self, item);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circles_of(files: &[(&str, &str)]) -> Vec<String> {
        let parse = |(path, text): &(&str, &str)| RustFile::parse(Path::new(path), text).expect("Rust");
        circles(&RustFiles { files: files.iter().map(parse).collect() }).expect("a count").places
    }

    #[test]
    fn files_that_import_each_other_are_a_circle() {
        let lib = ("a/src/lib.rs", "mod one; mod two;");
        let one = ("a/src/one.rs", "use crate::two::Two; pub struct One(Two);");
        let ties =
            circles_of(&[lib, one, ("a/src/two.rs", "use super::one::One; pub struct Two(Box<One>);")]);
        assert_eq!(ties.len(), 1);
        assert!(ties[0].contains("a/src/two.rs -> a/src/one.rs: One"), "{ties:?}");
        assert!(circles_of(&[lib, one, ("a/src/two.rs", "pub struct Two;")]).is_empty());
    }

    #[test]
    fn what_a_module_passes_on_counts_for_the_file_that_defines_it() {
        let module = ("a/src/m/mod.rs", "mod x; mod y; pub use x::*; pub use y::Y as Other; pub struct Own;");
        let lib = ("a/src/lib.rs", "mod m;");
        let free = [
            lib,
            module,
            ("a/src/m/x.rs", "use super::Other; pub struct X;"),
            ("a/src/m/y.rs", "pub struct Y;"),
        ];
        assert!(circles_of(&free).is_empty(), "a module that passes on is no user");
        let bound = [lib, module, free[2], ("a/src/m/y.rs", "use crate::m::X; pub struct Y;")];
        let ties = circles_of(&bound);
        assert!(ties[0].starts_with("a/src/m/x.rs, a/src/m/y.rs"), "{ties:?}");
    }

    #[test]
    fn tests_and_other_packages_do_not_count() {
        let lib = ("a/src/lib.rs", "mod one; mod two;");
        let one = (
            "a/src/one.rs",
            "use std::two::Two; #[cfg(test)] mod tests { use crate::two::Two; } pub struct One;",
        );
        assert!(circles_of(&[lib, one, ("a/src/two.rs", "use crate::one::One;")]).is_empty());
    }
}
