//! The embedded web viewer: its files, and a self-contained page with a model inside.
//!
//! The page needs neither a server nor a network: scripts and styles are inlined, and the decoder and the
//! model are embedded as base64, where the viewer looks for them. Cost: memory of about three times the page.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use rust_embed::RustEmbed;

use striata_command::failure::Failure;
use striata_command::page::escaped;

/// Files of the viewer, as built from `web/`.
#[derive(RustEmbed)]
#[folder = "viewer/"]
pub struct ViewerFiles;

/// Returns the viewer as a single page, with a model (file name and bytes) embedded if given.
///
/// # Errors
/// If the embedded viewer is incomplete.
pub fn self_contained(model: Option<(&str, &[u8])>) -> Result<String, Failure> {
    let file = |name: &str| ViewerFiles::get(name).map(|file| file.data.into_owned());
    assemble(&file, model)
}

fn assemble(
    file: &impl Fn(&str) -> Option<Vec<u8>>,
    model: Option<(&str, &[u8])>,
) -> Result<String, Failure> {
    let text = |name: &str| {
        let bytes =
            file(name).ok_or_else(|| Failure::internal(format!("the embedded viewer has no {name}")))?;
        String::from_utf8(bytes)
            .map_err(|_| Failure::internal(format!("{name} of the embedded viewer is not valid UTF-8")))
    };
    let mut page = text("index.html")?;
    if let Some(tag) = tag_naming(&page, "link", "viewer.css") {
        page.replace_range(
            tag,
            &format!("<style>{}</style>", escape_end_tags(&text("viewer.css")?, "style")),
        );
    }
    let script = tag_naming(&page, "script", "viewer.js");
    let script =
        script.ok_or_else(|| Failure::internal("the page of the embedded viewer does not load viewer.js"))?;
    let mut inlined = String::new();
    if let Some(wasm) = file("striata.wasm") {
        let wasm = BASE64.encode(wasm);
        inlined += &format!("<script type=\"text/plain\" id=\"striata-wasm\">{wasm}</script>\n");
    }
    if let Some((name, bytes)) = model {
        let (name, bytes) = (escaped(name), BASE64.encode(bytes));
        inlined += "<script type=\"text/plain\" id=\"striata-model\" ";
        inlined += &format!("data-name=\"{name}\">{bytes}</script>\n");
    }
    let code = escape_end_tags(&text("viewer.js")?, "script");
    inlined += &format!("<script type=\"module\">{code}</script>");
    page.replace_range(script, &inlined);
    Ok(page)
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
    use super::*;

    fn fixture(name: &str) -> Option<Vec<u8>> {
        let text = match name {
            "index.html" => {
                "<head><link rel=\"icon\" href=\"data:,\"><link rel=\"stylesheet\" href=\"./viewer.css\">\
                 <script type=\"module\" crossorigin src=\"./viewer.js\"></script></head>"
            }
            "viewer.js" => "const end = '</script>', note = '<!--';",
            "viewer.css" => "p { color: red }",
            "striata.wasm" => "\0asm",
            _ => return None,
        };
        Some(text.as_bytes().to_vec())
    }

    #[test]
    fn scripts_styles_decoder_and_model_move_into_the_page() {
        let page = assemble(&fixture, Some(("a\"b<c>.stri", b"foobar"))).expect("all parts");
        let expected = "<head><link rel=\"icon\" href=\"data:,\"><style>p { color: red }</style>\
             <script type=\"text/plain\" id=\"striata-wasm\">AGFzbQ==</script>\n\
             <script type=\"text/plain\" id=\"striata-model\" data-name=\"a&quot;b&lt;c&gt;.stri\">Zm9vYmFy</script>\n\
             <script type=\"module\">const end = '<\\/script>', note = '<\\!--';</script></head>";
        assert_eq!(page, expected);
    }

    #[test]
    fn missing_parts_are_reported() {
        let without = |missing: &'static str| move |name: &str| fixture(name).filter(|_| name != missing);
        for missing in ["index.html", "viewer.js", "viewer.css"] {
            assert!(assemble(&without(missing), None).is_err(), "{missing} is not reported");
        }
        assert!(assemble(&|name: &str| fixture(name).map(|_| b"<p>".to_vec()), None).is_err());
    }

    #[test]
    fn the_embedded_viewer_assembles() {
        let page = self_contained(Some(("ball.stri", b"1234"))).expect("all parts");
        assert!(page.contains("data-name=\"ball.stri\">MTIzNA==</script>"));
        assert_eq!(tag_naming(&page, "script", "viewer.js"), None, "everything is inlined");
    }
}
