//! Paged files on a web server, read in ranges.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpListener;
use std::path::PathBuf;

use striata::ignore_progress;
use striata_paged::PagedFile;
use striata_paged::build::{BuildInput, BuildOptions, BuildPaths, PagedPlan, run_all};

/// Serves the files of a folder, as far as requests ask for ranges; returns the address.
fn serve(folder: PathBuf) -> String {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = format!("http://{}", listener.local_addr().unwrap());
    std::thread::spawn(move || {
        for stream in listener.incoming().flatten() {
            let folder = folder.clone();
            std::thread::spawn(move || {
                let mut reader = BufReader::new(stream.try_clone().unwrap());
                let mut writer = stream;
                loop {
                    let (mut path, mut range) = (String::new(), None);
                    for (i, line) in reader.by_ref().lines().map_while(Result::ok).enumerate() {
                        if line.is_empty() {
                            break;
                        }
                        if i == 0 {
                            path = line.split(' ').nth(1).unwrap_or_default().to_owned();
                        }
                        if let Some(value) = line.to_ascii_lowercase().strip_prefix("range: bytes=") {
                            let (from, to) = value.split_once('-').unwrap();
                            range = Some((from.parse::<usize>().unwrap(), to.parse::<usize>().unwrap()));
                        }
                    }
                    if path.is_empty() {
                        return;
                    }
                    let file = std::fs::read(folder.join(path.trim_start_matches('/')));
                    let (Ok(bytes), Some((from, to))) = (file, range) else {
                        let _ = writer.write_all(b"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n");
                        continue;
                    };
                    let to = to.min(bytes.len() - 1);
                    let head = format!(
                        "HTTP/1.1 206 Partial Content\r\nContent-Range: bytes {from}-{to}/{}\r\n\
                         Content-Length: {}\r\nLast-Modified: Tue, 24 Nov 2026 10:00:00 GMT\r\n\r\n",
                        bytes.len(),
                        to + 1 - from,
                    );
                    let _ = writer.write_all(head.as_bytes());
                    let _ = writer.write_all(&bytes[from..=to]);
                }
            });
        }
    });
    address
}

#[test]
fn files_and_folders_are_read_in_ranges() {
    let folder = tempfile::TempDir::new().unwrap();
    for name in ["t.striata", "pages"] {
        let options = BuildOptions { cell: 2000, ..BuildOptions::default() };
        let (output, work) = (folder.path().join(name), folder.path().join("work"));
        let input = BuildInput::Terrain(200);
        let plan = PagedPlan::make(
            input,
            options,
            BuildPaths { output: &output, folder: &work },
            1,
            &mut ignore_progress,
        )
        .unwrap();
        run_all(&plan, 1, &mut ignore_progress).unwrap();
        plan.remove_work().unwrap();
    }
    let address = serve(folder.path().to_owned());
    let mut local = PagedFile::open(folder.path().join("t.striata").to_str().unwrap()).unwrap();
    let expected = local.level_for_triangles(1000).unwrap();
    for name in ["t.striata", "pages"] {
        let mut file = PagedFile::open(&format!("{address}/{name}")).unwrap();
        let level = file.level_for_triangles(1000).unwrap();
        assert_eq!(level.refinable, expected.refinable);
        assert_eq!(file.statistics().page_count, local.statistics().page_count);
    }
    let missing = PagedFile::open(&format!("{address}/missing.striata"));
    assert!(missing.err().unwrap().to_string().contains("missing.striata"));
}

#[test]
fn files_and_folders_are_written_to_addresses() {
    let folder = tempfile::TempDir::new().unwrap();
    let options = BuildOptions { cell: 2000, ..BuildOptions::default() };
    let build = |output: &std::path::Path| {
        let (input, options) = (BuildInput::Terrain(200), options.clone());
        let work = folder.path().join("work");
        let plan =
            PagedPlan::make(input, options, BuildPaths { output, folder: &work }, 1, &mut ignore_progress)
                .unwrap();
        let result = run_all(&plan, 1, &mut ignore_progress);
        plan.remove_work().unwrap();
        result
    };
    build(&folder.path().join("local.striata")).unwrap();
    let address = format!("file://{}", folder.path().display());
    build(format!("{address}/remote.striata").as_ref()).unwrap();
    build(format!("{address}/pages").as_ref()).unwrap();
    let read = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    assert!(read("local.striata") == read("remote.striata"));
    let mut pages = PagedFile::open(&format!("{address}/pages")).unwrap();
    let mut local = PagedFile::open(folder.path().join("local.striata").to_str().unwrap()).unwrap();
    let [found, expected] = [&mut pages, &mut local].map(|file| file.level_for_triangles(1000).unwrap());
    assert_eq!(found.refinable, expected.refinable);
    // A server that takes nothing: the build fails, and says where.
    let nowhere = serve(folder.path().to_owned());
    let error = build(format!("{nowhere}/refused").as_ref()).unwrap_err().to_string();
    assert!(error.contains("refused"), "{error}");
    let unknown = PagedPlan::make(
        BuildInput::Terrain(200),
        options.clone(),
        BuildPaths { output: "unknown://bucket/a".as_ref(), folder: &folder.path().join("work") },
        1,
        &mut ignore_progress,
    );
    assert!(unknown.unwrap_err().to_string().contains("unknown://bucket/a"));
}
