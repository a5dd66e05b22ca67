//! `serve`, as used by browsers, scripts and attackers.

use std::io::Read;
use std::os::unix::fs::symlink;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::workbench::{Workbench, assert_keys, sphere};
use striata_testing::server::{
    Answer, Connection, FILE, LoadPlan, PATIENCE, Server, memory_kb, run, write_file,
};

const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

fn program() -> PathBuf {
    assert_cmd::cargo::cargo_bin("striata")
}

/// Creates a folder with models, subfolders, and files that must not be served.
fn folder() -> Workbench {
    let bench = Workbench::with_ball();
    bench.run("encode sphere.obj -o ball.stri --quiet").success();
    for name in ["sub folder", ".hidden", "outside", "sub folder/deep"] {
        std::fs::create_dir(bench.path(name)).expect("the folder is ours");
    }
    let inner = bench.path("outside");
    bench.write("outside/secret.ply", "ply\n");
    let served = bench.path("sub folder");
    std::fs::copy(bench.path("sphere.obj"), served.join("ä #1.obj")).expect("the folder is ours");
    std::fs::copy(bench.path("ball.stri"), served.join("deep/ball.stri")).expect("the folder is ours");
    bench.write("sub folder/.hidden.obj", "v 0 0 0\n");
    bench.write("sub folder/notes.txt", "nothing to see\n");
    bench.write("sub folder/broken.ply", "ply\nformat ascii 1.0\nelement vertex 3\n");
    bench.write("sub folder/buffer.bin", "0123456789");
    symlink(inner.join("secret.ply"), served.join("absolute.ply")).expect("the folder is ours");
    symlink("../outside/secret.ply", served.join("relative.ply")).expect("the folder is ours");
    symlink("../outside", served.join("way-out")).expect("the folder is ours");
    symlink("deep/ball.stri", served.join("inside.stri")).expect("the folder is ours");
    bench
}

fn serve(bench: &Workbench, served: &str, arguments: &[&str]) -> Server {
    Server::start(&program(), &bench.path(served), arguments)
}

fn connect(server: &Server) -> Connection {
    Connection::open(server.address).expect("the server listens")
}

fn get(server: &Server, path: &str, headers: &str) -> Answer {
    connect(server).get(path, headers).expect("an answer")
}

/// Path of the viewer's script, which the page names.
fn script(server: &Server) -> String {
    let page = String::from_utf8(get(server, "/", "").body).expect("UTF-8");
    let (_, rest) = page.split_once("src=\"./viewer-").expect("the page loads a script");
    let (hash, _) = rest.split_once('"').expect("the attribute ends");
    format!("/viewer-{hash}")
}

#[test]
fn the_list_contains_all_visible_models_and_nothing_else() {
    let bench = folder();
    let server = serve(&bench, "sub folder", &[]);
    assert_eq!(server.report["models"], 4);
    let answer = get(&server, "/models.json", "");
    assert_eq!((answer.status, answer.header("content-type")), (200, "application/json"));
    let list: Value = serde_json::from_slice(&answer.body).expect("JSON");
    assert_eq!((&list["name"], &list["is_cut"]), (&"sub folder".into(), &false.into()));
    let models = list["models"].as_array().expect("models");
    let paths: Vec<&str> = models.iter().filter_map(|model| model["path"].as_str()).collect();
    assert_eq!(paths, ["broken.ply", "deep/ball.stri", "inside.stri", "ä #1.obj"]);
    for model in models {
        assert_keys(model, &["name", "url", "bytes", "modified_secs", "kind", "vertex_count", "picture"]);
        let url = model["url"].as_str().expect("a URL");
        let file = get(&server, &format!("/{url}"), "");
        assert_eq!(
            (file.status, file.body.len() as u64),
            (200, model["bytes"].as_u64().unwrap_or(0)),
            "{url}"
        );
    }
    let stream = &models[1];
    assert_eq!((&stream["kind"], &stream["streams"]), (&"stri".into(), &true.into()));
    assert_eq!((&stream["triangle_count"], &stream["vertex_count"]), (&512.into(), &258.into()));
    assert_eq!(stream["name"], "ball.stri");
    assert_eq!(models[0]["triangle_count"], Value::Null);
    let again = get(&server, "/models.json", &format!("if-none-match: {}\r\n", answer.header("etag")));
    assert_eq!((again.status, again.body.len()), (304, 0));
}

#[test]
fn the_list_is_sent_in_parts_and_compressed() {
    let bench = Workbench::new();
    for number in 0..40 {
        bench.write(&format!("model-{number:02}.obj"), sphere(3, 3));
    }
    let server = serve(&bench, ".", &[]);
    let whole = get(&server, "/models.json", "");
    let packed = get(&server, "/models.json", "accept-encoding: gzip\r\n");
    assert_eq!(packed.header("content-encoding"), "gzip");
    assert!(packed.body.len() * 4 < whole.body.len());
    let mut unpacked = Vec::new();
    flate2::read::GzDecoder::new(&packed.body[..]).read_to_end(&mut unpacked).expect("gzip");
    assert_eq!(unpacked, whole.body);
    let names = |path: &str| -> (Vec<String>, Value) {
        let list: Value = serde_json::from_slice(&get(&server, path, "").body).expect("JSON");
        let models = list["models"].as_array().expect("models");
        let names = models.iter().filter_map(|model| model["name"].as_str()).map(str::to_owned);
        (names.collect(), list["total"].clone())
    };
    assert_eq!(
        names("/models.json?from=38&count=5"),
        (vec!["model-38.obj".to_owned(), "model-39.obj".to_owned()], 40.into())
    );
    assert_eq!(names("/models.json?count=1").0, ["model-00.obj"]);
    assert!(names("/models.json?from=99").0.is_empty());
    assert_eq!(get(&server, "/models.json?from=x", "").status, 400);
}

#[test]
fn requests_for_another_version_fail() {
    let bench = folder();
    let server = serve(&bench, "sub folder", &[]);
    let path = "/models/buffer.bin";
    let tag = get(&server, path, "").header("etag").to_owned();
    assert_eq!(get(&server, path, &format!("if-match: {tag}\r\nrange: bytes=0-3\r\n")).status, 206);
    assert_eq!(get(&server, path, "if-match: \"other\"\r\nrange: bytes=0-3\r\n").status, 412);
    let past = "if-unmodified-since: Thu, 01 Jan 1970 00:00:01 GMT\r\n";
    assert_eq!(get(&server, path, past).status, 412);
}

#[test]
fn silent_clients_do_not_keep_others_out() {
    let bench = Workbench::with_ball();
    let server = serve(&bench, ".", &["--max-connections", "4", "--time-out", "600"]);
    let mut silent: Vec<Connection> = (0..40).map(|_| connect(&server)).collect();
    for client in &mut silent {
        // Some may have been closed already.
        let _ = client.say("GET /models.json HTTP/1.1\r\n");
    }
    assert_eq!(get(&server, "/models.json", "").status, 200);
}

#[test]
fn the_list_follows_the_folder() {
    let bench = Workbench::with_ball();
    let server = serve(&bench, ".", &[]);
    let before = get(&server, "/models.json", "");
    bench.write("another.obj", sphere(3, 3));
    std::fs::remove_file(bench.path("ball.striata")).expect("the folder is ours");
    std::thread::sleep(Duration::from_millis(1100));
    let after = get(&server, "/models.json", &format!("if-none-match: {}\r\n", before.header("etag")));
    let list: Value = serde_json::from_slice(&after.body).expect("JSON");
    let names: Vec<&str> =
        list["models"].as_array().expect("models").iter().filter_map(|m| m["name"].as_str()).collect();
    assert_eq!(names, ["another.obj", "sphere.obj"]);
}

#[test]
fn no_path_leads_out_of_the_folder_or_to_hidden_files() {
    let bench = folder();
    let server = serve(&bench, "sub folder", &[]);
    let mut connection = connect(&server);
    let mut status = |path: &str| {
        let answer = connection.get(path, "").expect("an answer");
        assert!(answer.status == 200 || !answer.body.starts_with(b"ply"), "{path}");
        answer.status
    };
    let script = script(&server);
    for there in ["/models/inside.stri", "/models/buffer.bin", "/models/%C3%A4%20%231.obj", "/", &script] {
        assert_eq!(status(there), 200, "{there}");
    }
    let models = [
        "absolute.ply",
        "relative.ply",
        "way-out/secret.ply",
        "../outside/secret.ply",
        "..%2Foutside%2Fsecret.ply",
        "%2e%2e/outside/secret.ply",
        "deep/../../outside/secret.ply",
        "..%5Coutside%5Csecret.ply",
        "/etc/passwd",
        "%2Fetc%2Fpasswd",
        "inside.stri%00.ply",
        "inside.stri%0d%0aset-cookie:a",
        "inside.stri/",
        "deep",
        "deep/",
        "./inside.stri",
        "deep//ball.stri",
        ".hidden.obj",
        "notes.txt",
        "nothing.ply",
        "%ff%fe.ply",
        "%",
        "",
    ];
    for path in models {
        assert_eq!(status(&format!("/models/{path}")), 404, "{path}");
        assert_eq!(status(&format!("/pictures/{path}.png")), 404, "{path}");
    }
    let in_script = format!("{script}/");
    let paths =
        ["/../../etc/passwd", "/%2e%2e/Cargo.toml", &in_script, "/models", "/pictures/", "//etc/passwd"];
    for path in paths {
        assert_eq!(status(path), 404, "{path}");
    }
}

#[test]
fn byte_ranges_are_served() {
    let bench = folder();
    let server = serve(&bench, ".", &[]);
    let bytes = bench.read("ball.striata");
    let length = bytes.len();
    let part = |headers: &str| get(&server, "/models/ball.striata", headers);
    let whole = part("");
    assert_eq!((whole.status, whole.header("accept-ranges")), (200, "bytes"));
    assert_eq!(whole.body, bytes);
    for (range, expected) in [
        ("0-99", &bytes[..100]),
        ("100-100", &bytes[100..101]),
        ("500-", &bytes[500..]),
        ("-7", &bytes[length - 7..]),
        ("7-99999999", &bytes[7..]),
        ("-99999999", &bytes[..]),
    ] {
        let answer = part(&format!("range: bytes={range}\r\n"));
        assert_eq!((answer.status, answer.body.as_slice()), (206, expected), "{range}");
        let start = expected.as_ptr() as usize - bytes.as_ptr() as usize;
        let content_range = format!("bytes {start}-{}/{length}", start + expected.len() - 1);
        assert_eq!(answer.header("content-range"), content_range);
        assert_eq!(answer.header("etag"), whole.header("etag"));
    }
    let none = part(&format!("range: bytes={length}-\r\n"));
    assert_eq!((none.status, none.header("content-range")), (416, format!("bytes */{length}").as_str()));
    for ignored in ["bytes=5-2", "bytes=0-1,3-4", "pages=1-2", "bytes"] {
        assert_eq!(part(&format!("range: {ignored}\r\n")).body, bytes, "{ignored}");
    }
    let mut connection = connect(&server);
    connection.say("HEAD /models/ball.striata HTTP/1.1\r\nhost: localhost\r\n\r\n").expect("sent");
    let head = connection.answer(false).expect("an answer");
    assert_eq!((head.status, head.header("content-length")), (200, length.to_string().as_str()));
    assert_eq!(
        connection.get("/models/ball.stri", "").expect("nothing followed").body,
        bench.read("ball.stri")
    );
}

#[test]
fn cached_files_are_sent_again_only_after_changes() {
    let bench = folder();
    let server = serve(&bench, ".", &[]);
    let ask = |headers: &str| get(&server, "/models/ball.stri", headers);
    let first = ask("");
    let (tag, date) = (first.header("etag"), first.header("last-modified"));
    assert!(tag.starts_with('"') && date.ends_with(" GMT"), "{first:?}");
    assert_eq!(ask(&format!("if-none-match: {tag}\r\n")).status, 304);
    assert_eq!(ask(&format!("if-none-match: \"x\", {tag}\r\n")).status, 304);
    assert_eq!(ask("if-none-match: \"x\"\r\n").status, 200);
    assert_eq!(ask(&format!("if-modified-since: {date}\r\n")).status, 304);
    assert_eq!(ask(&format!("if-none-match: \"x\"\r\nif-modified-since: {date}\r\n")).status, 200);
    let part = |condition: &str| ask(&format!("range: bytes=0-9\r\nif-range: {condition}\r\n")).status;
    assert_eq!(
        [part(tag), part(date), part("\"x\""), part("Mon, 01 Jan 2001 00:00:00 GMT")],
        [206, 206, 200, 200]
    );
    // Another file of the same length under the same name.
    bench.write("next", vec![7; first.body.len()]);
    std::fs::rename(bench.path("next"), bench.path("ball.stri")).expect("the folder is ours");
    let second = ask(&format!("if-none-match: {tag}\r\nrange: bytes=0-9\r\nif-range: {tag}\r\n"));
    assert_eq!((second.status, second.body.len()), (200, first.body.len()));
    assert_ne!(second.header("etag"), tag);
}

#[test]
fn only_complete_text_files_are_compressed() {
    let bench = folder();
    bench.run("convert sphere.obj ascii.ply --ascii --quiet").success();
    bench.run("convert sphere.obj binary.ply --quiet").success();
    let server = serve(&bench, ".", &[]);
    let ask =
        |path: &str, headers: &str| get(&server, path, &format!("accept-encoding: gzip, br\r\n{headers}"));
    let plain = get(&server, "/models/sphere.obj", "");
    assert_eq!((plain.header("content-encoding"), plain.header("content-type")), ("", "model/obj"));
    for name in ["sphere.obj", "ascii.ply"] {
        let answer = ask(&format!("/models/{name}"), "");
        assert_eq!((answer.status, answer.header("content-encoding")), (200, "gzip"), "{name}");
        let mut unpacked = Vec::new();
        flate2::read::GzDecoder::new(answer.body.as_slice()).read_to_end(&mut unpacked).expect("valid gzip");
        assert!(unpacked == bench.read(name) && answer.body.len() < unpacked.len() / 2, "{name}");
        let again = ask(&format!("/models/{name}"), &format!("if-none-match: {}\r\n", answer.header("etag")));
        assert_eq!(again.status, 304);
    }
    assert_ne!(ask("/models/sphere.obj", "").header("etag"), plain.header("etag"));
    let part = ask("/models/sphere.obj", "range: bytes=0-9\r\n");
    assert_eq!(
        (part.status, part.header("content-encoding"), part.header("etag")),
        (206, "", plain.header("etag"))
    );
    for name in ["ball.striata", "ball.stri", "binary.ply"] {
        let answer = ask(&format!("/models/{name}"), "");
        assert_eq!(answer.header("content-encoding"), "", "{name}");
        assert_eq!(answer.body, bench.read(name), "{name}");
    }
}

#[test]
fn the_viewer_is_compressed_once_and_has_a_content_security_policy() {
    let bench = folder();
    let server = serve(&bench, ".", &[]);
    let page = get(&server, "/", "");
    assert_eq!((page.status, page.header("cache-control")), (200, "no-cache"));
    assert!(page.body.starts_with(b"<!doctype html>"));
    for (name, value) in
        [("x-content-type-options", "nosniff"), ("cross-origin-resource-policy", "same-origin")]
    {
        assert_eq!(page.header(name), value);
        assert_eq!(get(&server, "/models/nothing", "").header(name), value, "errors have it, too");
    }
    assert!(page.header("content-security-policy").contains("'wasm-unsafe-eval'"));
    assert_eq!(page.header("access-control-allow-origin"), "");
    let script = script(&server);
    let plain = get(&server, &script, "");
    let packed = |coding: &str| {
        let until = Instant::now() + PATIENCE;
        loop {
            let answer = get(&server, &script, &format!("accept-encoding: {coding}\r\n"));
            if answer.header("content-encoding") == coding {
                return answer;
            }
            assert!(Instant::now() < until, "{coding} is never ready");
            std::thread::sleep(Duration::from_millis(50));
        }
    };
    let (gzip, brotli) = (packed("gzip"), packed("br"));
    assert!(gzip.body.len() < plain.body.len() && brotli.body.len() < plain.body.len());
    let mut unpacked = Vec::new();
    flate2::read::GzDecoder::new(gzip.body.as_slice()).read_to_end(&mut unpacked).expect("valid gzip");
    assert_eq!(unpacked, plain.body);
    let tags = [&plain, &gzip, &brotli].map(|answer| answer.header("etag").to_owned());
    assert!(tags[0] != tags[1] && tags[1] != tags[2] && tags[0] != tags[2], "{tags:?}");
    let again = get(&server, &script, &format!("if-none-match: {}\r\n", tags[0]));
    assert_eq!(again.status, 304);
    assert_eq!(again.header("cache-control"), plain.header("cache-control"));
}

#[test]
fn only_files_named_by_their_contents_are_cached_without_asking() {
    let bench = folder();
    let server = serve(&bench, ".", &[]);
    let cached = |path: &str| {
        let answer = get(&server, path, "");
        assert_eq!(answer.status, 200, "{path}");
        assert!(!answer.header("etag").is_empty(), "{path} has a validator, too");
        answer.header("cache-control").to_owned()
    };
    let page = String::from_utf8(get(&server, "/", "").body).expect("UTF-8");
    let names: Vec<&str> = page.split("\"./").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    assert!(names.len() >= 2, "the page names its script and style: {names:?}");
    for name in names {
        assert_eq!(cached(&format!("/{name}")), "public, max-age=31536000, immutable", "{name}");
    }
    for path in [
        "/",
        "/index.html",
        "/models.json",
        "/models/ball.stri",
        "/models/sphere.obj",
        "/pictures/ball.stri.png",
    ] {
        assert_eq!(cached(path), "no-cache", "{path}");
    }
}

#[test]
fn models_have_pictures_and_damaged_ones_a_placeholder() {
    let bench = folder();
    let server = serve(&bench, "sub folder", &[]);
    let picture = |path: &str| {
        let answer = get(&server, &format!("/pictures/{path}.png"), "");
        assert_eq!((answer.status, answer.header("content-type")), (200, "image/png"), "{path}");
        assert!(answer.body.starts_with(PNG), "{path}");
        assert_eq!(answer.body[16..24], [0, 0, 1, 64, 0, 0, 0, 240], "{path}: 320 x 240");
        answer
    };
    let broken = picture("broken.ply");
    let (stream, mesh) = (picture("deep/ball.stri"), picture("%C3%A4%20%231.obj"));
    assert!(stream.body != broken.body && mesh.body != broken.body);
    assert_eq!(picture("deep/ball.stri").body, stream.body);
    let again = format!("if-none-match: {}\r\n", stream.header("etag"));
    assert_eq!(get(&server, "/pictures/deep/ball.stri.png", &again).status, 304);
    assert_eq!(get(&server, "/pictures/buffer.bin.png", "").status, 404, "no model");
    // Once repaired, the model gets its own picture.
    std::fs::copy(bench.path("sphere.obj"), bench.path("sub folder/broken.ply")).expect("the folder is ours");
    assert_eq!(picture("broken.ply").body, mesh.body);
}

#[test]
fn thumbnails_of_all_formats_are_similar() {
    let bench = folder();
    let picture = |name: &str| {
        let assert = bench.run(&format!("thumbnail {name}")).success();
        let png = assert.get_output().stdout.clone();
        assert!(png.starts_with(PNG), "{name}");
        png
    };
    assert_eq!(picture("sphere.obj"), picture("sphere.obj"));
    assert!(picture("ball.stri").len() > 5_000 && picture("ball.striata").len() > 5_000);
    assert!(bench.refused("thumbnail nothing.ply").contains("nothing.ply"));
}

#[test]
fn unknown_host_names_are_refused() {
    let bench = folder();
    let server = serve(&bench, ".", &[]);
    let status = |head: &str| {
        let mut connection = connect(&server);
        connection.say(&format!("GET /models.json HTTP/1.1\r\n{head}\r\n")).expect("sent");
        connection.answer(true).expect("an answer").status
    };
    let port = server.address.port();
    for allowed in
        ["localhost".to_owned(), format!("LOCALHOST:{port}"), format!("127.0.0.1:{port}"), "[::1]".to_owned()]
    {
        assert_eq!(status(&format!("host: {allowed}\r\n")), 200, "{allowed}");
    }
    for bad in
        ["example.com", "localhost.example.com", "127.0.0.1.nip.io:80", "user@localhost", "192.168.0.1"]
    {
        assert_eq!(status(&format!("host: {bad}\r\n")), 421, "{bad}");
    }
    assert_eq!([status(""), status("host: localhost\r\nhost: example.com\r\n")], [400, 400]);
    let mut connection = connect(&server);
    connection.say("GET http://example.com/models.json HTTP/1.1\r\nhost: localhost\r\n\r\n").expect("sent");
    assert_eq!(connection.answer(true).expect("an answer").status, 421);
}

#[test]
fn proxies_can_be_allowed_by_name() {
    let bench = folder();
    let server = serve(&bench, ".", &["--allow-host", "models.example.com", "--allow-host", "10.1.2.3"]);
    let status = |host: &str| {
        let mut connection = connect(&server);
        connection.say(&format!("GET /models.json HTTP/1.1\r\nhost: {host}\r\n\r\n")).expect("sent");
        connection.answer(true).expect("an answer").status
    };
    for allowed in ["models.example.com", "Models.Example.com:443", "10.1.2.3:8080", "localhost"] {
        assert_eq!(status(allowed), 200, "{allowed}");
    }
    for bad in ["example.com", "models.example.com.evil.com", "a@models.example.com", "10.1.2.4"] {
        assert_eq!(status(bad), 421, "{bad}");
    }
    for bad in ["https://models.example.com", "models.example.com:443", "*"] {
        let refused = bench.refused(&format!("serve . --port 0 --allow-host {bad}"));
        assert!(refused.contains("name or address of a host"), "{refused}");
    }
}

#[test]
fn uploads_are_refused_and_other_origins_need_cors() {
    let bench = folder();
    let server = serve(&bench, ".", &["--cors"]);
    let origin = "origin: https://example.com\r\n";
    let answer = get(&server, "/models/ball.stri", &format!("{origin}range: bytes=0-1\r\n"));
    assert_eq!((answer.status, answer.header("access-control-allow-origin")), (206, "*"));
    assert!(answer.header("access-control-expose-headers").contains("content-range"));
    assert_eq!(answer.header("cross-origin-resource-policy"), "cross-origin");
    for method in ["POST", "PUT", "DELETE", "PATCH"] {
        for path in ["/models/ball.stri", "/models.json", "/"] {
            let mut connection = connect(&server);
            let request = format!("{method} {path} HTTP/1.1\r\nhost: localhost\r\ncontent-length: 0\r\n\r\n");
            connection.say(&request).expect("sent");
            assert_eq!(connection.answer(true).expect("an answer").status, 405, "{method} {path}");
        }
    }
    let mut connection = connect(&server);
    let _ =
        connection.say(&format!("GET / HTTP/1.1\r\nhost: localhost\r\nx: {}\r\n\r\n", "y".repeat(300_000)));
    assert!(connection.answer(true).map_or(true, |answer| answer.status == 431), "a head without end");
}

#[test]
fn a_single_file_is_served_with_the_files_it_refers_to() {
    let bench = folder();
    let server = serve(&bench, "ball.stri", &[]);
    assert_eq!(server.report["models"], 1);
    assert_eq!(get(&server, "/models/ball.stri", "").body, bench.read("ball.stri"));
    for other in ["ball.striata", "sphere.obj", "sub%20folder/buffer.bin"] {
        assert_eq!(get(&server, &format!("/models/{other}"), "").status, 404, "{other}");
    }
    let list: Value = serde_json::from_slice(&get(&server, "/models.json", "").body).expect("JSON");
    assert_eq!(list["models"].as_array().map(Vec::len), Some(1));
    let textured = serve(&bench, "sphere.obj", &[]);
    bench.write("sphere.mtl", "newmtl stone\n");
    assert_eq!(get(&textured, "/models/sphere.mtl", "").status, 200);
}

#[test]
fn wrong_arguments_are_refused() {
    let bench = folder();
    let server = serve(&bench, ".", &[]);
    let port = server.address.port();
    let busy = bench.refused(&format!("serve . --port {port}"));
    assert!(busy.contains("the port is already in use") && busy.contains("hint: use --port 0"), "{busy}");
    assert!(bench.refused("serve nowhere").contains("nowhere"));
    bench.write("notes.txt", "");
    assert!(bench.refused("serve notes.txt").contains("not a folder or a model"));
    assert!(bench.refused("serve . --port 0 --host 203.0.113.7").contains("--host must be"));
}

#[test]
fn a_terminated_server_finishes_its_responses() {
    let bench = Workbench::new();
    write_file(&bench.path("."));
    let server = serve(&bench, ".", &[]);
    let mut connection = connect(&server);
    connection.say(&format!("GET /models/{FILE} HTTP/1.1\r\nhost: localhost\r\n\r\n")).expect("sent");
    let mut idle = connect(&server);
    assert_eq!(idle.get("/models.json", "").expect("an answer").status, 200);
    let reader = std::thread::spawn(move || connection.answer(true).map(|answer| answer.body.len()));
    let address = server.address;
    let status = server.end();
    assert!(status.success(), "{status}");
    assert_eq!(reader.join().expect("no panic").expect("all of it"), bench.read(FILE).len());
    assert!(Connection::open(address).is_err(), "nobody listens any more");
}

#[test]
fn idle_and_stalled_connections_are_dropped() {
    let bench = Workbench::new();
    write_file(&bench.path("."));
    let server = serve(&bench, ".", &["--max-connections", "2", "--time-out", "1"]);
    let mut silent = connect(&server);
    silent.say("GET /models.json HTTP/1.1\r\n").expect("sent");
    let mut stalled = connect(&server);
    stalled.say(&format!("GET /models/{FILE} HTTP/1.1\r\nhost: localhost\r\n\r\n")).expect("sent");
    // Two requests are answered at the same time only once both connections are free.
    let are_free = || {
        let (mut one, mut other) = (connect(&server), connect(&server));
        let asks =
            |client: &mut Connection| client.get("/models.json", "").is_ok_and(|answer| answer.status == 200);
        asks(&mut one) && asks(&mut other) && asks(&mut one)
    };
    let until = Instant::now() + PATIENCE;
    while !are_free() {
        assert!(Instant::now() < until, "the places are never free");
    }
    assert!(silent.answer(true).is_err(), "no request was sent");
    assert!(stalled.answer(true).is_err(), "the rest was given up");
}

#[test]
fn many_clients_get_correct_bytes_and_memory_stays_constant() {
    let bench = Workbench::new();
    write_file(&bench.path("."));
    let server = serve(&bench, ".", &[]);
    let idle_kb = memory_kb(server.id(), "VmHWM:").unwrap_or(0);
    let outcome = run(&server, LoadPlan { quick: 46, slow: 4, lasts: Duration::from_secs(3) });
    assert_eq!(outcome.errors, [""; 0]);
    assert!(outcome.latencies.len() > 46 && outcome.slow_bytes >= 4 * 2048, "{outcome:?}");
    // The code of the command counts as memory, too; it is larger in test builds and with a window.
    let used_kb = outcome.peak_kb - idle_kb;
    assert!(used_kb < 90_000, "{used_kb} kB over {idle_kb} kB");
}

/// A site has everything that the server would send, under the same addresses.
#[test]
fn a_site_has_the_page_the_models_and_their_pictures() {
    let bench = folder();
    let assert = bench.command("serve --write-to site --json").arg("sub folder").assert().success();
    let report: Value = serde_json::from_slice(&assert.get_output().stdout).expect("JSON");
    assert_keys(&report, &["folder", "models", "bytes"]);
    let listing: Value = serde_json::from_slice(&bench.read("site/models.json")).expect("JSON");
    let models = listing["models"].as_array().expect("a list");
    assert_eq!(report["models"], models.len());
    let picture_of = |path: &str| {
        let model = models.iter().find(|model| model["path"] == path).expect("it is listed");
        model["picture"].as_str().map(str::to_owned)
    };
    assert_eq!(picture_of("broken.ply"), None);
    let warning = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
    assert!(warning.contains("broken.ply is broken: "), "{warning}");
    assert_eq!(picture_of("ä #1.obj").as_deref(), Some("pictures/%C3%A4%20%231.obj.png"));
    assert!(bench.read("site/pictures/ä #1.obj.png").starts_with(PNG));
    for name in ["ä #1.obj", "deep/ball.stri", "buffer.bin"] {
        assert_eq!(bench.read(&format!("site/models/{name}")), bench.read(&format!("sub folder/{name}")));
    }
    // What must not be served is not copied either.
    for name in [".hidden.obj", "notes.txt", "absolute.ply", "relative.ply", "way-out"] {
        assert!(!bench.path(&format!("site/models/{name}")).exists(), "{name}");
    }
    let page = String::from_utf8(bench.read("site/index.html")).expect("UTF-8");
    let (_, rest) = page.split_once("src=\"./").expect("the page loads a script");
    let (script, _) = rest.split_once('"').expect("the attribute ends");
    assert!(bench.path(&format!("site/{script}")).is_file(), "{script}");
    assert!(bench.names().iter().all(|name| !name.contains("partial")), "{:?}", bench.names());
}

#[test]
fn sites_replace_nothing_and_need_a_folder() {
    let bench = folder();
    bench.write("outside/taken.txt", "mine");
    let message = bench.refused("serve deep --write-to outside").to_lowercase();
    assert!(message.contains("deep"), "{message}");
    for (served, to, reason) in [
        ("sub folder", "outside", "there is something already"),
        ("sub folder", "sub folder/site", "lies in the folder of the models"),
        ("ball.stri", "site", "is one model, and a site needs a folder"),
        ("sub folder", "missing/site", "missing"),
    ] {
        let assert = bench.command("serve").arg(served).arg("--write-to").arg(to).assert().failure();
        let message = String::from_utf8_lossy(&assert.get_output().stderr).into_owned();
        assert!(message.contains(reason), "{served} to {to}: {message}");
    }
    assert_eq!(bench.read("outside/taken.txt"), b"mine");
    assert!(!bench.path("site").exists() && !bench.path("missing").exists());
}
