//! The words of the command line before they are parsed, and hints for those that cannot be.

use std::ffi::{OsStr, OsString};
use std::path::Path;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, Error};

use crate::args::Cli;

/// Names that other tools have for the work of a verb.
const SYNONYMS: [(&str, &str); 14] = [
    ("decimate", "simplify"),
    ("reduce", "simplify"),
    ("lod", "simplify"),
    ("lods", "simplify"),
    ("optimize", "convert"),
    ("optimise", "convert"),
    ("copy", "convert"),
    ("compress", "encode"),
    ("pack", "encode"),
    ("decompress", "decode"),
    ("unpack", "decode"),
    ("inspect", "info"),
    ("validate", "info"),
    ("compare", "distance"),
];

/// Translates words that the parser has no verb for: `help`, `version`, and a file alone, which is viewed.
pub(crate) fn translated(words: impl IntoIterator<Item = OsString>) -> Vec<OsString> {
    let mut words: Vec<OsString> = words.into_iter().collect();
    let has_view = cfg!(feature = "serve");
    match words.get(1).and_then(|word| word.to_str()) {
        Some("help") => {
            words.remove(1);
            words.push("--help".into());
        }
        Some("version" | "-v") if words.len() == 2 => words[1] = "--version".into(),
        Some(word) if has_view && is_file(word) => words.insert(1, "view".into()),
        _ => {}
    }
    words
}

/// Whether a word is a file and no verb.
fn is_file(word: &str) -> bool {
    let is_verb = || Cli::command().find_subcommand(OsStr::new(word)).is_some();
    Path::new(word).is_file() && !word.starts_with('-') && !is_verb()
}

/// Returns a hint for a command line that cannot be parsed.
pub(crate) fn hint(error: &Error) -> Option<String> {
    match error.kind() {
        ErrorKind::InvalidSubcommand => {
            let Some(ContextValue::String(word)) = error.get(ContextKind::InvalidSubcommand) else {
                return None;
            };
            match SYNONYMS.iter().find(|(synonym, _)| synonym == word) {
                Some((_, verb)) => {
                    Some(format!("use `striata {verb}`; `striata {verb} --help` has examples"))
                }
                None if word.contains('.') => Some("there is no file of this name either".to_owned()),
                None => None,
            }
        }
        ErrorKind::MissingRequiredArgument => {
            let Some(ContextValue::Strings(missing)) = error.get(ContextKind::InvalidArg) else {
                return None;
            };
            let lacks_level = missing.iter().any(|argument| argument.contains("--ratio"));
            lacks_level.then(|| {
                "say how small: --ratio 0.1, --triangles 500, --error 0.5% or --levels 50%,10%".to_owned()
            })
        }
        _ => None,
    }
}
