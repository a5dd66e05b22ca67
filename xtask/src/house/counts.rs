//! Checks that look at each file by itself.

use std::collections::BTreeMap;

use anyhow::Result;
use syn::visit::{self, Visit};
use syn::{Attribute, Expr, FnArg, Lit, Meta, Signature, Type, VisRestricted};

use super::CountWithPlaces;
use super::sources::{RustFile, RustFiles, is_for_tests};

/// Beginnings of doc comments that do not say what the item is.
const WEAK_OPENINGS: &[&str] = &["What ", "The same ", "As above", "Those that ", "Where "];

/// Finds functions that take a tuple, which is a way around the limit of the number of parameters.
pub(super) fn tuple_parameters(sources: &RustFiles) -> Result<CountWithPlaces> {
    struct Tuples<'s>(&'s RustFile, Vec<String>);
    impl<'ast> Visit<'ast> for Tuples<'_> {
        fn visit_signature(&mut self, signature: &'ast Signature) {
            let is_tuple = |argument: &FnArg| match argument {
                FnArg::Typed(argument) => {
                    matches!(without_references(&argument.ty), Type::Tuple(tuple) if !tuple.elems.is_empty())
                }
                FnArg::Receiver(_) => false,
            };
            if signature.inputs.iter().any(is_tuple) {
                self.1.push(format!("{}: {}", self.0.path.display(), signature.ident));
            }
            visit::visit_signature(self, signature);
        }
    }
    Ok(in_each(sources, |source| Tuples(source, Vec::new()), |found| found.1))
}

fn without_references(mut ty: &Type) -> &Type {
    while let Type::Reference(reference) = ty {
        ty = &reference.elem;
    }
    ty
}

/// Finds doc comments whose first words are forbidden.
pub(super) fn weak_openings(sources: &RustFiles) -> Result<CountWithPlaces> {
    struct Openings<'s> {
        source: &'s RustFile,
        found: Vec<String>,
    }
    impl Openings<'_> {
        fn look(&mut self, attributes: &[Attribute]) {
            let Some(first) = attributes.iter().find_map(doc_line) else { return };
            let first = first.trim_start();
            if WEAK_OPENINGS.iter().any(|opening| first.starts_with(opening)) {
                self.found.push(format!("{}: {first}", self.source.path.display()));
            }
        }
    }
    impl<'ast> Visit<'ast> for Openings<'_> {
        fn visit_file(&mut self, file: &'ast syn::File) {
            self.look(&file.attrs);
            visit::visit_file(self, file);
        }
        fn visit_item(&mut self, item: &'ast syn::Item) {
            self.look(attributes_of_item(item));
            visit::visit_item(self, item);
        }
        fn visit_field(&mut self, field: &'ast syn::Field) {
            self.look(&field.attrs);
            visit::visit_field(self, field);
        }
        fn visit_variant(&mut self, variant: &'ast syn::Variant) {
            self.look(&variant.attrs);
            visit::visit_variant(self, variant);
        }
        fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
            self.look(&item.attrs);
            visit::visit_impl_item_fn(self, item);
        }
        fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
            self.look(&item.attrs);
            visit::visit_trait_item_fn(self, item);
        }
    }
    Ok(in_each(sources, |source| Openings { source, found: Vec::new() }, |openings| openings.found))
}

fn doc_line(attribute: &Attribute) -> Option<String> {
    let Meta::NameValue(meta) = &attribute.meta else { return None };
    match &meta.value {
        Expr::Lit(literal) if meta.path.is_ident("doc") => match &literal.lit {
            Lit::Str(text) => Some(text.value()),
            _ => None,
        },
        _ => None,
    }
}

fn attributes_of_item(item: &syn::Item) -> &[Attribute] {
    match item {
        syn::Item::Const(item) => &item.attrs,
        syn::Item::Enum(item) => &item.attrs,
        syn::Item::Fn(item) => &item.attrs,
        syn::Item::Mod(item) => &item.attrs,
        syn::Item::Static(item) => &item.attrs,
        syn::Item::Struct(item) => &item.attrs,
        syn::Item::Trait(item) => &item.attrs,
        syn::Item::Type(item) => &item.attrs,
        _ => &[],
    }
}

/// Counts `pub(crate)`, `pub(super)` and `pub(in ...)`: the more there are, the thinner are the walls between files.
pub(super) fn restricted_pub(sources: &RustFiles) -> Result<CountWithPlaces> {
    #[derive(Default)]
    struct Restricted(usize);
    impl<'ast> Visit<'ast> for Restricted {
        fn visit_vis_restricted(&mut self, _: &'ast VisRestricted) {
            self.0 += 1;
        }
    }
    let mut restricted = Restricted::default();
    sources.files.iter().for_each(|source| restricted.visit_file(&source.syntax));
    let count = 10_000 * restricted.0 / sources.line_count().max(1);
    Ok(CountWithPlaces { count, places: Vec::new() })
}

/// Finds names of types, outside of tests, that several places define.
pub(super) fn repeated_type_names(sources: &RustFiles) -> Result<CountWithPlaces> {
    struct Types<'s>(&'s RustFile, Vec<(String, String)>);
    impl<'ast> Visit<'ast> for Types<'_> {
        fn visit_item(&mut self, item: &'ast syn::Item) {
            let name = match item {
                _ if is_for_tests(attributes_of_item(item)) => return,
                syn::Item::Struct(item) => &item.ident,
                syn::Item::Enum(item) => &item.ident,
                syn::Item::Trait(item) => &item.ident,
                _ => return visit::visit_item(self, item),
            };
            self.1.push((name.to_string(), self.0.path.display().to_string()));
        }
        // Types within functions have no meaning outside.
        fn visit_block(&mut self, _: &'ast syn::Block) {}
    }
    let mut places_of: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for source in
        sources.files.iter().filter(|source| source.path.components().any(|part| part.as_os_str() == "src"))
    {
        let mut types = Types(source, Vec::new());
        types.visit_file(&source.syntax);
        types.1.into_iter().for_each(|(name, path)| places_of.entry(name).or_default().push(path));
    }
    let repeated = places_of.into_iter().filter(|(_, places)| places.len() > 1);
    Ok(repeated.map(|(name, places)| format!("{name}: {}", places.join(", "))).collect::<Vec<_>>().into())
}

/// Visits each file with a visitor of its own, and collects what they find.
fn in_each<'s, V: Visit<'s>>(
    sources: &'s RustFiles,
    visitor_of: impl Fn(&'s RustFile) -> V,
    found: impl Fn(V) -> Vec<String>,
) -> CountWithPlaces {
    let visit = |source: &'s RustFile| {
        let mut visitor = visitor_of(source);
        visitor.visit_file(&source.syntax);
        found(visitor)
    };
    sources.files.iter().flat_map(visit).collect::<Vec<_>>().into()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    fn sources(text: &str) -> RustFiles {
        RustFiles { files: vec![RustFile::parse(Path::new("a/src/lib.rs"), text).expect("Rust")] }
    }

    #[test]
    fn tuples_are_found_behind_references() {
        let found = tuple_parameters(&sources(
            "fn a((x, y): (u8, u8)) {} fn b(z: &&(u8, u8)) {} fn c(u: ()) {} struct S; impl S { fn d(&self, t: (S, S)) {} }",
        ));
        assert_eq!(
            found.expect("a count").places,
            ["a", "b", "d"].map(|name| format!("a/src/lib.rs: {name}"))
        );
    }

    #[test]
    fn only_first_words_of_comments_count() {
        let text = "//! What it is.\n/// A type.\n/// Where it is.\nstruct A { /// Where b is.\n b: u8 }\n/// The same.\nfn f() {}\n/// Whereas\nfn g() {}";
        assert_eq!(weak_openings(&sources(text)).expect("a count").count, 2);
    }

    #[test]
    fn restricted_items_are_counted_for_lines() {
        let text = "pub(crate) fn f() {}\npub(super) fn g() {}\npub fn h() {}\nfn i() {}";
        assert_eq!(restricted_pub(&sources(text)).expect("a count").count, 5_000);
    }

    #[test]
    fn types_of_equal_names_are_listed_once() {
        let text = "struct A; mod m { enum A {} } fn f() { struct B; } struct B; #[cfg(test)] mod tests { struct B; }";
        assert_eq!(repeated_type_names(&sources(text)).expect("a count").count, 1);
    }
}
