//! The embedded web viewer: its files, and a self-contained page with a model inside.
//!
//! The page needs neither a server nor a network: scripts and styles are inlined, and the modules (compressed)
//! and the model are embedded as base64, where the viewer looks for them. Cost: memory of about three times
//! the page.

use std::io::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use flate2::Compression;
use flate2::write::GzEncoder;
use rust_embed::RustEmbed;

use striata_command::failure::Failure;
use striata_command::page::escaped;

/// Files of the viewer, as built from `web/`: the page `index.html`, and files whose names contain a hash of
/// their contents.
#[derive(RustEmbed)]
#[folder = "viewer/"]
pub struct ViewerFiles;

/// Names of the wasm modules, up to their hash, and the ids under which a page looks for them.
const MODULES: [(&str, &str); 2] =
    [("striata-", "striata-wasm"), ("striata-encoder-", "striata-builder-wasm")];

/// Returns the viewer as a single page, with a model (file name and bytes) embedded if given.
///
/// # Errors
/// If the embedded viewer is incomplete.
pub fn self_contained(model: Option<(&str, &[u8])>) -> Result<String, Failure> {
    with_modules(model, &MODULES)
}

/// Returns the viewer as a single page that shows a stream. It lacks the module that reads other files, which
/// is most of the page: it cannot open files that are dropped on it, except for streams.
///
/// # Errors
/// If the embedded viewer is incomplete.
pub fn for_stream(name: &str, stream: &[u8]) -> Result<String, Failure> {
    with_modules(Some((name, stream)), &MODULES[..1])
}

fn with_modules(model: Option<(&str, &[u8])>, modules: &[(&str, &str)]) -> Result<String, Failure> {
    let names: Vec<String> = ViewerFiles::iter().map(|name| name.into_owned()).collect();
    let read = |name: &str| ViewerFiles::get(name).map(|file| file.data.into_owned());
    Files { names, read: &read }.assemble(model, modules)
}

/// Files of a page, whose names contain hashes.
struct Files<'a> {
    names: Vec<String>,
    read: &'a dyn Fn(&str) -> Option<Vec<u8>>,
}

impl Files<'_> {
    fn assemble(&self, model: Option<(&str, &[u8])>, modules: &[(&str, &str)]) -> Result<String, Failure> {
        let mut page = self.text("index.html")?;
        let name = self.name("viewer-", ".css").ok_or_else(|| lacks("viewer-*.css"))?;
        let tag = tag_naming(&page, "link", name).ok_or_else(|| not_loaded(name))?;
        page.replace_range(tag, &format!("<style>{}</style>", escape_end_tags(&self.text(name)?, "style")));
        let name = self.name("viewer-", ".js").ok_or_else(|| lacks("viewer-*.js"))?;
        let tag = tag_naming(&page, "script", name).ok_or_else(|| not_loaded(name))?;
        let mut inlined = String::new();
        for (start, id) in modules {
            let name = self.name(start, ".wasm").ok_or_else(|| lacks(start))?;
            let wasm = BASE64.encode(gzipped(&self.bytes(name)?)?);
            inlined += &format!("<script type=\"text/plain\" id=\"{id}\">{wasm}</script>\n");
        }
        if let Some((name, bytes)) = model {
            let (name, bytes) = (escaped(name), BASE64.encode(bytes));
            inlined += "<script type=\"text/plain\" id=\"striata-model\" ";
            inlined += &format!("data-name=\"{name}\">{bytes}</script>\n");
        }
        let code = escape_end_tags(&self.text(name)?, "script");
        inlined += &format!("<script type=\"module\">{code}</script>");
        page.replace_range(tag, &inlined);
        Ok(page)
    }

    /// The file whose name starts and ends like this, with a hash in between.
    fn name(&self, start: &str, end: &str) -> Option<&str> {
        let is_hash = |text: &str| text.bytes().all(|byte| byte.is_ascii_hexdigit());
        let hash = |name: &str| Some(is_hash(name.strip_prefix(start)?.strip_suffix(end)?));
        self.names.iter().map(String::as_str).find(|&name| hash(name) == Some(true))
    }

    fn bytes(&self, name: &str) -> Result<Vec<u8>, Failure> {
        (self.read)(name).ok_or_else(|| lacks(name))
    }

    fn text(&self, name: &str) -> Result<String, Failure> {
        String::from_utf8(self.bytes(name)?)
            .map_err(|_| Failure::internal(format!("{name} of the embedded viewer is not valid UTF-8")))
    }
}

fn gzipped(bytes: &[u8]) -> Result<Vec<u8>, Failure> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder
        .write_all(bytes)
        .and_then(|()| encoder.finish())
        .map_err(|error| Failure::internal(format!("cannot compress the embedded viewer: {error}")))
}

fn lacks(name: &str) -> Failure {
    Failure::internal(format!("the embedded viewer has no {name}"))
}

fn not_loaded(name: &str) -> Failure {
    Failure::internal(format!("the page of the embedded viewer does not load {name}"))
}

/// Byte range of the element whose start tag names a file, including the end tag if it follows immediately.
fn tag_naming(page: &str, element: &str, file: &str) -> Option<std::ops::Range<usize>> {
    let opening = format!("<{element} ");
    let starts = page.match_indices(&opening).map(|(start, _)| start);
    let mut tags = starts.filter_map(|start| Some(start..start + page[start..].find('>')? + 1));
    let names = |tag: &str| ["\"", "\"./", "'", "'./"].iter().any(|q| tag.contains(&format!("{q}{file}")));
    let tag = tags.find(|tag| names(&page[tag.clone()]))?;
    let closing = format!("</{element}>");
    let rest = &page[tag.end..];
    Some(match rest.starts_with(&closing) {
        true => tag.start..tag.end + closing.len(),
        false => tag,
    })
}

/// Escapes end tags and comments in code, so that they do not end the element around it: `\/` equals `/` in
/// strings and regular expressions.
fn escape_end_tags(code: &str, element: &str) -> String {
    code.replace(&format!("</{element}"), &format!("<\\/{element}")).replace("<!--", "<\\!--")
}

#[cfg(test)]
mod tests {
    use std::io::Read as _;

    use super::*;

    const NAMES: [&str; 5] =
        ["index.html", "viewer-12ab.css", "viewer-34cd.js", "striata-encoder-78.wasm", "striata-56ef.wasm"];

    fn fixture(name: &str) -> Option<Vec<u8>> {
        let text = match name {
            "index.html" => {
                "<head><link rel=\"icon\" href=\"data:,\"><link rel=\"stylesheet\" href=\"./viewer-12ab.css\">\
                 <script type=\"module\" crossorigin src=\"./viewer-34cd.js\"></script></head>"
            }
            "viewer-34cd.js" => "const end = '</script>', note = '<!--';",
            "viewer-12ab.css" => "p { color: red }",
            "striata-56ef.wasm" => "\0asm",
            "striata-encoder-78.wasm" => "\0asm2",
            _ => return None,
        };
        Some(text.as_bytes().to_vec())
    }

    fn files<'a>(missing: &str, read: &'a dyn Fn(&str) -> Option<Vec<u8>>) -> Files<'a> {
        let names = NAMES.into_iter().filter(|name| *name != missing).map(str::to_owned).collect();
        Files { names, read }
    }

    #[test]
    fn scripts_styles_decoder_and_model_move_into_the_page() {
        let page =
            files("", &fixture).assemble(Some(("a\"b<c>.stri", b"foobar")), &MODULES).expect("all parts");
        let expected = "<head><link rel=\"icon\" href=\"data:,\"><style>p { color: red }</style>\
             <script type=\"text/plain\" id=\"striata-wasm\">{decoder}</script>\n\
             <script type=\"text/plain\" id=\"striata-builder-wasm\">{encoder}</script>\n\
             <script type=\"text/plain\" id=\"striata-model\" data-name=\"a&quot;b&lt;c&gt;.stri\">Zm9vYmFy</script>\n\
             <script type=\"module\">const end = '<\\/script>', note = '<\\!--';</script></head>";
        let embedded = |wasm: &[u8]| BASE64.encode(gzipped(wasm).expect("compresses"));
        let expected = expected.replace("{decoder}", &embedded(b"\0asm"));
        assert_eq!(page, expected.replace("{encoder}", &embedded(b"\0asm2")));
    }

    #[test]
    fn embedded_modules_are_compressed_without_loss() {
        let bytes: Vec<u8> = (0..100_000u32).map(|i| (i / 100) as u8).collect();
        let compressed = gzipped(&bytes).expect("compresses");
        assert!(compressed.len() < bytes.len() / 10);
        let mut read = Vec::new();
        flate2::read::GzDecoder::new(compressed.as_slice()).read_to_end(&mut read).expect("gzip");
        assert_eq!(read, bytes);
    }

    #[test]
    fn missing_parts_are_reported() {
        for missing in ["index.html", "viewer-34cd.js", "viewer-12ab.css"] {
            let read = |name: &str| fixture(name).filter(|_| name != missing);
            assert!(files("", &read).assemble(None, &MODULES).is_err(), "{missing} is not reported");
        }
        for missing in ["viewer-34cd.js", "viewer-12ab.css"] {
            assert!(files(missing, &fixture).assemble(None, &MODULES).is_err(), "{missing} is not listed");
        }
        let empty = |name: &str| fixture(name).map(|_| b"<p>".to_vec());
        assert!(files("", &empty).assemble(None, &MODULES).is_err(), "a page without tags");
    }

    #[test]
    fn the_embedded_viewer_assembles() {
        let page = self_contained(Some(("ball.stri", b"1234"))).expect("all parts");
        assert!(page.contains("data-name=\"ball.stri\">MTIzNA==</script>"));
        let smaller = for_stream("ball.stri", b"1234").expect("all parts");
        assert!(page.contains("id=\"striata-wasm\"") && page.contains("id=\"striata-builder-wasm\""));
        assert!(smaller.contains("id=\"striata-wasm\"") && !smaller.contains("id=\"striata-builder-wasm\""));
        assert!(smaller.len() < page.len() * 2 / 3, "{} and {} bytes", smaller.len(), page.len());
        for name in ViewerFiles::iter().filter(|name| name.ends_with(".js") || name.ends_with(".css")) {
            assert!(!page.contains(&format!("\"./{name}\"")), "{name} is inlined");
        }
    }
}
