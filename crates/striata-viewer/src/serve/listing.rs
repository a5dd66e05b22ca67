//! `models.json`: what there is to see.
//!
//! The folder is walked again when somebody asks, at most once a second, and heads are read only of files that are new or have
//! changed. Cost: a look at each entry; memory of a few hundred bytes a model.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;
use std::time::{Duration, Instant};

use axum::body::Bytes;
use axum::extract::State;
use axum::http::header::CONTENT_TYPE;
use axum::http::{HeaderMap, HeaderValue};
use axum::response::{IntoResponse, Response};
use serde::Serialize;
use striata_io::Format;
use tokio::sync::Mutex;

use super::folder::{Folder, Stamp, encoded};
use super::heads::Head;
use super::validators::{Coding, Validators};

/// A list so old is made anew.
const FRESH_FOR: Duration = Duration::from_secs(1);

/// The list of models, kept while it is fresh.
#[derive(Debug)]
pub(super) struct Listing {
    folder: Arc<Folder>,
    kept: Mutex<Kept>,
}

#[derive(Debug, Default)]
struct Kept {
    list: List,
    made: Option<Instant>,
    heads: BTreeMap<String, (Stamp, Head)>,
}

/// One state of the list.
#[derive(Clone, Debug, Default)]
pub(super) struct List {
    /// Models in it.
    pub(super) model_count: usize,
    json: Bytes,
    tag: String,
}

#[derive(Serialize)]
struct Document<'a> {
    name: String,
    models: Vec<Model<'a>>,
    /// Whether there are more models than are listed.
    is_cut: bool,
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
    picture: String,
}

/// Answers for `models.json`.
pub(super) async fn answer(State(listing): State<Arc<Listing>>, request: HeaderMap) -> Response {
    let list = listing.current().await;
    let validators = Validators::new(&list.tag, Coding::Plain, None);
    if let Some(response) = validators.not_modified(&request) {
        return response;
    }
    let mut response = list.json.into_response();
    validators.apply(&mut response);
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static("application/json"));
    response
}

impl Listing {
    /// No list yet.
    pub(super) fn new(folder: Arc<Folder>) -> Self {
        Self { folder, kept: Mutex::default() }
    }

    /// The list; whoever asks while it is made waits for it.
    pub(super) async fn current(&self) -> List {
        let mut kept = self.kept.lock().await;
        if kept.made.is_some_and(|made| made.elapsed() < FRESH_FOR) {
            return kept.list.clone();
        }
        let (folder, heads) = (self.folder.clone(), std::mem::take(&mut kept.heads));
        // A walk that panics leaves an old list, which is better than none.
        if let Ok((list, heads)) = tokio::task::spawn_blocking(move || make(&folder, heads)).await {
            (kept.list, kept.heads) = (list, heads);
        }
        kept.made = Some(Instant::now());
        kept.list.clone()
    }
}

/// The list, and the heads of all that is in it.
fn make(
    folder: &Folder,
    mut known: BTreeMap<String, (Stamp, Head)>,
) -> (List, BTreeMap<String, (Stamp, Head)>) {
    let walked = folder.walk();
    let mut heads = BTreeMap::new();
    for (name, stamp) in walked.models {
        let known = known.remove(&name).filter(|(state, _)| *state == stamp);
        let head = known.map_or_else(|| head_of(folder, &name), |(_, head)| head);
        heads.insert(name, (stamp, head));
    }
    let models = heads.iter().map(|(path, &(stamp, head))| Model::new(path, stamp, head)).collect();
    let document = Document {
        name: folder.only().map_or_else(|| folder.name(), str::to_owned),
        models,
        is_cut: walked.is_cut,
    };
    // Numbers and texts are all that is in it: nothing that JSON cannot say.
    let json = serde_json::to_vec(&document).unwrap_or_default();
    let mut hasher = DefaultHasher::new();
    json.hash(&mut hasher);
    let tag = format!("{:x}-{:x}", json.len(), hasher.finish());
    (List { model_count: heads.len(), json: json.into(), tag }, heads)
}

fn head_of(folder: &Folder, name: &str) -> Head {
    let found = folder.find(&encoded(name));
    found.map_or_else(Head::default, |mut found| Head::read(name, &mut found.file, found.stamp.bytes))
}

impl<'a> Model<'a> {
    fn new(path: &'a str, stamp: Stamp, head: Head) -> Self {
        let url = encoded(path);
        Self {
            name: path.rsplit('/').next().unwrap_or(path),
            path,
            bytes: stamp.bytes,
            modified_secs: stamp.modified_secs(),
            kind: Format::from_extension(path).map_or("", Format::extension),
            streams: head.streams,
            triangle_count: head.triangle_count,
            vertex_count: head.vertex_count,
            picture: format!("pictures/{url}.png"),
            url: format!("models/{url}"),
        }
    }
}
