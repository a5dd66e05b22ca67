use super::*;
use crate::mesh::Random;

const LAYOUT: RecordLayout = RecordLayout {
    kind_count: 300,
    short_kind_bits: 0,
    half_edge_count: 60,
    has_errors: false,
    has_wide_counts: false,
};

/// Random drafts; one in `rare` steps has many links, an unusual corner or listed vertices.
fn drafts(count: u32, rare: u32, has_errors: bool, seed: u64) -> Vec<Draft> {
    let mut random = Random::new(seed);
    let mut below = |limit: u32| if limit == 0 { 0 } else { random.below(limit) };
    (0..count)
        .map(|step| {
            let is_rare = below(rare) == 0;
            let ups = if step + 1 == count { 0 } else { below(if is_rare { 40 } else { 8 }) };
            let downs = if step == 0 { 0 } else { below(if is_rare { 20 } else { 4 }) };
            Draft {
                // Low kinds are frequent.
                kind: below(300).min(below(300)).min(below(300)),
                up: (0..ups)
                    .map(|_| UpLink {
                        above: step + 1 + below(count - step - 1),
                        code: below(if is_rare { 60 } else { 16 }),
                        error: if has_errors { below(256) } else { 0 },
                    })
                    .collect(),
                down: (0..downs).map(|_| below(step)).collect(),
                extras: (0..if is_rare { below(3) } else { 0 }).map(|_| below(step + 9)).collect(),
            }
        })
        .collect()
}

fn read(records: &Records) -> Vec<Draft> {
    let draft = |step| {
        let head = records.head(step);
        Draft {
            kind: head.kind,
            up: records.ups(&head).collect(),
            down: records.downs(&head).collect(),
            extras: records.extras(&head).collect(),
        }
    };
    (0..records.step_count as u32).map(draft).collect()
}

#[test]
fn records_are_read_as_they_were_packed() {
    for (seed, count) in [0, 1, 2, 15, 16, 17, 200, 1000].into_iter().enumerate() {
        for rare in [2, 50, 10_000] {
            for has_errors in [false, true] {
                let drafts = drafts(count, rare, has_errors, seed as u64 + 1);
                let records = Records::pack(&drafts, RecordLayout { has_errors, ..LAYOUT }).unwrap();
                assert_eq!(read(&records), drafts);
                let (blocks, bits) = records.parts();
                let bits = Bits::from_bytes(bits.as_bytes(), bits.len()).unwrap();
                let again = Records::from_parts(count as usize, records.layout(), blocks.to_vec(), bits);
                assert_eq!(again.as_ref(), Ok(&records));
            }
        }
    }
}

#[test]
fn damaged_records_are_refused_or_stay_within_their_bits() {
    let drafts = drafts(100, 20, true, 3);
    let records = Records::pack(&drafts, RecordLayout { has_errors: true, ..LAYOUT }).unwrap();
    let (blocks, bits) = records.parts();
    let mut refused = 0;
    let mut check = |blocks: Vec<u32>, bytes: &[u8]| {
        let Some(bits) = Bits::from_bytes(bytes, bits.len()) else { return };
        match Records::from_parts(drafts.len(), records.layout(), blocks, bits) {
            Ok(damaged) => drop(read(&damaged)),
            Err(_) => refused += 1,
        }
    };
    for (place, bit) in (0..blocks.len()).flat_map(|place| (0..32).map(move |bit| (place, bit))) {
        let mut damaged = blocks.to_vec();
        damaged[place] ^= 1 << bit;
        check(damaged, bits.as_bytes());
    }
    for place in 0..bits.len() {
        let mut damaged = bits.as_bytes().to_vec();
        damaged[place / 8] ^= 1 << (place % 8);
        check(blocks.to_vec(), &damaged);
    }
    assert!(refused > 500, "{refused} of them are refused");
}

#[test]
fn counts_are_summed_in_one_word() {
    let mut random = Random::new(8);
    for _ in 0..200 {
        let numbers: Vec<u64> = (0..16).map(|_| u64::from(random.below(16))).collect();
        let nibbles = (0..).zip(&numbers).fold(0, |all, (k, number)| all | number << (4 * k));
        let pairs = (0..).zip(&numbers).fold(0, |all, (k, number)| all | (*number as u32 & 3) << (2 * k));
        for k in 0..16 {
            let before = &numbers[..k as usize];
            let sum = |of: fn(u64) -> u64| before.iter().map(|&number| of(number) as u32).sum::<u32>();
            let expected = (sum(|number| number & 7), sum(|number| number >> 3));
            assert_eq!(sums_of_nibbles(nibbles & ((1 << (4 * k)) - 1)), expected);
            assert_eq!(sum_of_pairs(pairs & ((1 << (2 * k)) - 1)), sum(|number| number & 3));
        }
        assert_eq!(sum_of_pairs(u32::MAX), 48);
    }
}
