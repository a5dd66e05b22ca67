//! `models.json`: the list of models.
//!
//! A request may ask for a part of it, `models.json?from=100&count=50`, and for gzip.
//!
//! The folder is walked again on request, at most once per second, and headers are read only from new or
//! changed files. Cost: a stat of each entry; a few hundred bytes of memory per model.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;
use std::time::{Duration, Instant};

use async_compression::Level;
use async_compression::tokio::bufread::GzipEncoder;
use axum::body::Bytes;
use axum::extract::{Query, State};
use axum::http::header::{CONTENT_ENCODING, CONTENT_TYPE};
use axum::http::{HeaderMap, HeaderValue};
use axum::response::{IntoResponse, Response};
use serde::{Deserialize, Serialize};
use striata_io::Format;
use tokio::io::AsyncReadExt as _;
use tokio::sync::Mutex;

use super::folder::{Folder, Stamp, encoded};
use super::header_facts::{HeaderFacts, companions};
use super::validators::{Coding, Validators};

/// Age after which the list is rebuilt.
const FRESH_FOR: Duration = Duration::from_secs(1);

/// The list of models, cached while it is fresh.
#[derive(Debug)]
pub(super) struct Listing {
    folder: Arc<Folder>,
    ends_with_page: bool,
    cache: Mutex<Cache>,
}

#[derive(Debug, Default)]
struct Cache {
    list: List,
    built_at: Option<Instant>,
    heads: BTreeMap<String, (Stamp, HeaderFacts)>,
}

/// One version of the list.
#[derive(Clone, Debug, Default)]
pub(super) struct List {
    /// Number of models.
    pub model_count: usize,
    name: String,
    models: Arc<[(String, Stamp, HeaderFacts)]>,
    /// Whether a limit was reached and models are missing.
    pub is_cut: bool,
    ends_with_page: bool,
    json: Bytes,
    tag: String,
}

#[derive(Serialize)]
struct Document<'a> {
    name: &'a str,
    models: Vec<Model<'a>>,
    /// Number of models in the whole list.
    total: usize,
    /// Whether the list was truncated.
    is_cut: bool,
    /// Whether the server stops when its page is closed; the page reports that.
    ends_with_page: bool,
}

/// The part of the list that a request asks for: `models.json?from=100&count=50`.
#[derive(Clone, Copy, Debug, Default, Deserialize)]
pub(super) struct Wanted {
    #[serde(default)]
    from: usize,
    count: Option<usize>,
}

#[derive(Serialize)]
struct Model<'a> {
    name: &'a str,
    path: &'a str,
    url: String,
    bytes: u64,
    modified_secs: u64,
    kind: &'static str,
    streams: bool,
    triangle_count: Option<u64>,
    vertex_count: Option<u64>,
    picture: Option<String>,
}

/// Handles requests for `models.json`.
pub(super) async fn handle(
    State(listing): State<Arc<Listing>>,
    Query(wanted): Query<Wanted>,
    request: HeaderMap,
) -> Response {
    let list = listing.current().await;
    let is_whole = wanted.from == 0 && wanted.count.is_none();
    let (json, tag) = match is_whole {
        true => (list.json.clone(), list.tag.clone()),
        false => {
            let part = format!("{}-{}-{}", list.tag, wanted.from, wanted.count.unwrap_or(usize::MAX));
            (list.part(wanted), part)
        }
    };
    let coding = Coding::chosen(&request, &[Coding::Gzip]);
    let validators = Validators::new(&tag, coding, None);
    if let Some(response) = validators.answered(&request) {
        return response;
    }
    let mut response = match coding {
        Coding::Plain => json.into_response(),
        _ => {
            let mut packed = Vec::new();
            let mut encoder = GzipEncoder::with_quality(&json[..], Level::Fastest);
            // Reading from memory does not fail.
            let _ = encoder.read_to_end(&mut packed).await;
            let mut response = packed.into_response();
            response.headers_mut().insert(CONTENT_ENCODING, HeaderValue::from_static("gzip"));
            response
        }
    };
    validators.apply(&mut response);
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static("application/json"));
    response
}

impl List {
    /// Paths of the models within the folder, with their states.
    pub(super) fn stamps(&self) -> impl Iterator<Item = (&str, Stamp)> {
        self.models.iter().map(|(path, stamp, _)| (path.as_str(), *stamp))
    }

    /// The document with all models, of which some have a picture.
    pub(super) fn document(&self, has_picture: impl Fn(&str) -> bool) -> Bytes {
        self.part_with(Wanted::default(), has_picture)
    }

    /// The document with some of the models.
    fn part(&self, wanted: Wanted) -> Bytes {
        self.part_with(wanted, |_| true)
    }

    fn part_with(&self, Wanted { from, count }: Wanted, has_picture: impl Fn(&str) -> bool) -> Bytes {
        let from = from.min(self.models.len());
        let to = from.saturating_add(count.unwrap_or(usize::MAX)).min(self.models.len());
        let models = self.models[from..to].iter();
        let document = Document {
            name: &self.name,
            models: models
                .map(|(path, stamp, head)| {
                    let model = Model::new(path, *stamp, *head);
                    if has_picture(path) { model } else { Model { picture: None, ..model } }
                })
                .collect(),
            total: self.models.len(),
            is_cut: self.is_cut,
            ends_with_page: self.ends_with_page,
        };
        // The document contains only numbers and strings, so serialization cannot fail.
        serde_json::to_vec(&document).unwrap_or_default().into()
    }
}

impl Listing {
    /// Creates a listing whose list is built on the first request.
    pub(super) fn new(folder: Arc<Folder>, ends_with_page: bool) -> Self {
        Self { folder, ends_with_page, cache: Mutex::default() }
    }

    /// Returns the list; concurrent callers wait while it is rebuilt.
    pub(super) async fn current(&self) -> List {
        let mut cache = self.cache.lock().await;
        if cache.built_at.is_some_and(|built_at| built_at.elapsed() < FRESH_FOR) {
            return cache.list.clone();
        }
        let (folder, heads) = (self.folder.clone(), std::mem::take(&mut cache.heads));
        let ends = self.ends_with_page;
        // If the walk panics, the old list is kept.
        if let Ok((list, heads)) = tokio::task::spawn_blocking(move || build_list(&folder, heads, ends)).await
        {
            (cache.list, cache.heads) = (list, heads);
        }
        cache.built_at = Some(Instant::now());
        cache.list.clone()
    }
}

/// Builds the list and returns it with what the header of each file says.
fn build_list(
    folder: &Folder,
    mut known: BTreeMap<String, (Stamp, HeaderFacts)>,
    ends_with_page: bool,
) -> (List, BTreeMap<String, (Stamp, HeaderFacts)>) {
    let walked = folder.walk();
    let mut heads = BTreeMap::new();
    for (name, stamp) in walked.files {
        let known = known.remove(&name).filter(|(state, _)| *state == stamp);
        let head = known.map_or_else(|| read_header(folder, &name), |(_, head)| head);
        heads.insert(name, (stamp, head));
    }
    let mut list = List {
        model_count: heads.len(),
        name: folder.only().map_or_else(|| folder.name(), str::to_owned),
        models: heads.iter().map(|(path, &(stamp, head))| (path.clone(), stamp, head)).collect(),
        is_cut: walked.is_truncated,
        ends_with_page,
        ..List::default()
    };
    list.json = list.part(Wanted::default());
    let mut hasher = DefaultHasher::new();
    list.json.hash(&mut hasher);
    list.tag = format!("{:x}-{:x}", list.json.len(), hasher.finish());
    (list, heads)
}

fn read_header(folder: &Folder, name: &str) -> HeaderFacts {
    let Some(mut found) = folder.find(&encoded(name)) else { return HeaderFacts::default() };
    let mut facts = HeaderFacts::read(name, &mut found.file, found.stamp.bytes);
    let base = name.rsplit_once('/').map_or(String::new(), |(base, _)| format!("{base}/"));
    // URIs in documents are percent-encoded, or should be.
    let size_of = |uri: &String| {
        let path = format!("{}{uri}", encoded_folder(&base));
        folder.find(&path).or_else(|| folder.find(&encoded(&format!("{base}{uri}"))))
    };
    let files = companions(name, &mut found.file, found.stamp.bytes);
    facts.companion_bytes = files.iter().filter_map(size_of).map(|found| found.stamp.bytes).sum();
    facts
}

/// Percent-encodes a folder that ends with a slash, or is empty.
fn encoded_folder(base: &str) -> String {
    base.strip_suffix('/').map_or(String::new(), |base| format!("{}/", encoded(base)))
}

impl<'a> Model<'a> {
    fn new(path: &'a str, stamp: Stamp, head: HeaderFacts) -> Self {
        let url = encoded(path);
        Self {
            name: path.rsplit('/').next().unwrap_or(path),
            path,
            bytes: stamp.bytes + head.companion_bytes,
            modified_secs: stamp.modified_secs(),
            kind: Format::from_extension(path).map_or("", Format::extension),
            streams: head.streams,
            triangle_count: head.triangle_count,
            vertex_count: head.vertex_count,
            picture: Some(format!("pictures/{url}.png")),
            url: format!("models/{url}"),
        }
    }
}
