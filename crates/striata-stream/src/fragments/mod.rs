//! Fragments of any simplifier in a stream: steps that replace a few triangles by others, one record after another
//! \[KG98\] 3.1.
//!
//! \[KG98\] stores the rule of a fragment and two anchor vertices, 44 bits in all. Here the floor of a fragment is
//! found from one of its triangles: for each side of a triangle that is known to belong to it, a bit says whether the
//! triangle across does, too. The ceiling of a removed position follows from the border of the floor, since each side
//! of the border gets a triangle with a restored vertex, unless the side stays a border of the mesh. What that does not
//! describe is listed corner by corner. So a rule costs only as much as it surprises, and there is no table of rules.
//!
//! | file | what it does |
//! | --- | --- |
//! | `faces.rs` | [`LevelFaces`](faces::LevelFaces): the triangles of a level, and which one lies across a side |
//! | `record.rs` | [`FragmentCoder`](record::FragmentCoder): codes fragments, for writer and reader |
//! | `values.rs` | [`ValueCoder`](values::ValueCoder): codes positions and attributes of the restored vertices |

pub(crate) mod faces;
pub(crate) mod record;
pub(crate) mod values;
