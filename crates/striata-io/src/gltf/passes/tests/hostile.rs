//! Damaged documents are survived.

use proptest::prelude::*;
use serde_json::{Value, json};

use super::everything;
use crate::report::Warnings;
use crate::{QuantizeOptions, WriteOptions};

/// Returns the number of values in a document.
fn count(value: &Value) -> usize {
    1 + match value {
        Value::Array(entries) => entries.iter().map(count).sum(),
        Value::Object(members) => members.values().map(count).sum(),
        _ => 0,
    }
}

/// Returns value number `place` of a document, counted in depth-first order.
fn value_at<'a>(value: &'a mut Value, place: &mut usize) -> Option<&'a mut Value> {
    if *place == 0 {
        return Some(value);
    }
    *place -= 1;
    match value {
        Value::Array(entries) => entries.iter_mut().find_map(|entry| value_at(entry, place)),
        Value::Object(members) => members.values_mut().find_map(|member| value_at(member, place)),
        _ => None,
    }
}

fn strange() -> impl Strategy<Value = Value> {
    prop_oneof![
        Just(json!(null)),
        Just(json!(-1)),
        Just(json!(0.5)),
        Just(json!(1e30)),
        Just(json!(u64::MAX)),
        Just(json!(1u64 << 40)),
        Just(json!("SCALAR")),
        Just(json!([])),
        Just(json!({})),
        Just(json!([{}, 3])),
        Just(json!({ "POSITION": 1 })),
        Just(json!(true)),
        (0u64..40).prop_map(|number| json!(number)),
        (5118u64..5128).prop_map(|number| json!(number)),
    ]
}

proptest! {
    #![proptest_config(striata_testing::cases(if cfg!(debug_assertions) { 400 } else { 4000 }))]

    #[test]
    fn strange_values_are_survived(
        changes in proptest::collection::vec((0usize..100_000, strange()), 1..6),
        bytes in proptest::collection::vec((0usize..100_000, any::<u8>()), 0..4),
        cut in 0usize..4,
    ) {
        let mut parts = everything();
        for (place, value) in changes {
            let mut place = place % count(&parts.root);
            if let Some(slot) = value_at(&mut parts.root, &mut place) {
                *slot = value;
            }
        }
        for (place, value) in bytes {
            let length = parts.binary.len();
            parts.binary[place % length] = value;
        }
        if cut == 0 {
            parts.binary.truncate(parts.binary.len() / 2);
        }
        let quantize = WriteOptions::default().with_quantize(QuantizeOptions::default());
        for options in [
            quantize.clone(),
            WriteOptions::default().with_meshopt(cfg!(feature = "meshopt")),
            quantize.with_draco(cfg!(feature = "draco")),
        ] {
            let mut out = parts.clone();
            prop_assert!(out.apply(&options, &mut Warnings::default()).is_ok());
            let before = parts.binary.len().max(1 << 16);
            prop_assert!(out.binary.len() <= 4 * before, "{} bytes became {}", before, out.binary.len());
        }
    }
}
