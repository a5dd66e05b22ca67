//! Tests of the numbers and words of text formats.

use super::*;

fn read(text: &str) -> f32 {
    Cursor::new(text.as_bytes()).f32().unwrap()
}

#[test]
fn numbers_are_the_nearest_f32() {
    let mut words: Vec<String> =
        ["0", "-0.0", "1", "+2.5", ".5", "5.", "1e3", "-1.25E-2", "16777217"].map(str::to_owned).to_vec();
    words.extend(["1e-45", "3.4028235e38", "0.1000000014901161193847656250001", "1e39"].map(str::to_owned));
    // The midpoint between 1 and the next `f32`, and a value slightly above it.
    words.push("1.000000059604644775390625".to_owned());
    words.push("1.0000000596046448".to_owned());
    let mut bits = 12_345u32;
    for _ in 0..20_000 {
        bits = bits.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let x = f32::from_bits(bits);
        if x.is_finite() {
            words.push(format!("{x}"));
            words.push(format!("{x:e}"));
            words.push(format!("{:.6}", x % 1000.0));
        }
    }
    for word in words {
        let expected: f32 = word.parse().unwrap();
        assert_eq!(read(&word).to_bits(), expected.to_bits(), "{word}");
    }
}

#[test]
fn digits_that_f32_loses_are_noticed() {
    let is_long = |text: &str| {
        let mut cursor = Cursor::new(text.as_bytes());
        cursor.coordinate().unwrap();
        (cursor.has_long_coordinates(), Cursor::new(text.as_bytes()).f64().unwrap())
    };
    for text in
        ["0", "-12.345678", "500000", "0.1234567", "1e10", "1234.567", "0.100000001490116119384765625"]
    {
        assert!(!is_long(text).0, "{text}");
    }
    for text in
        ["500000.123", "-5000000.05", "0.123456789", "16777217", "0.10000000000000000000000", "1e-30000"]
    {
        assert_eq!(is_long(text), (text != "1e-30000", text.parse().unwrap()), "{text}");
    }
    // Programs in single precision print any number of places.
    let mut bits = 4_321u32;
    for _ in 0..20_000 {
        bits = bits.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let x = f32::from_bits(bits);
        let x = if x.abs() < 1e12 { x } else { x.fract() };
        for text in
            [format!("{x:.6}"), format!("{x:.9}"), format!("{x:.17}"), format!("{x}"), format!("{x:.9e}")]
        {
            assert!(!is_long(&text).0 || !x.is_finite(), "{text} of {x}");
        }
    }
}

#[test]
fn unusual_words_are_numbers_or_errors() {
    assert!(read("nan").is_nan());
    assert_eq!(read("-inf"), f32::NEG_INFINITY);
    for word in ["-nan(ind)", "nan(0x7)", "1.#QNAN", "-1.#IND00", "1.#INF", "-1.#INF", "1.#J", "-NaN"] {
        assert!(!read(word).is_finite(), "{word}");
    }
    for word in ["", "-", "abc", "1.2.3", "1e", "0x10", "--1", "1,5"] {
        assert!(Cursor::new(word.as_bytes()).f32().is_err(), "{word}");
    }
    assert_eq!(Cursor::new(b"3.0 ").integer().unwrap(), 3);
    for word in ["", "1.5", "99999999999999999999", "x", "-"] {
        assert!(Cursor::new(word.as_bytes()).integer().is_err(), "{word}");
    }
}

#[test]
fn exponents_of_fortran_are_read() {
    for word in ["1.25D+02", "1.25d2", "-.5D0", "123456789012345678901D-18", "0.1000000014901161193847D+0"] {
        let expected = word.replace(['d', 'D'], "e");
        assert_eq!(read(word), expected.parse::<f32>().unwrap(), "{word}");
        assert_eq!(Cursor::new(word.as_bytes()).f64().unwrap(), expected.parse::<f64>().unwrap(), "{word}");
    }
    let mut cursor = Cursor::new(b"5.000000123D+05");
    cursor.coordinate().unwrap();
    assert!(cursor.has_long_coordinates());
    assert_eq!(Cursor::new(b"3.0D+00").integer().unwrap(), 3);
    for word in ["1D", "D2", "1D2D3", "D", "0d-"] {
        assert!(Cursor::new(word.as_bytes()).f32().is_err(), "{word}");
    }
}

#[test]
#[cfg(feature = "obj")]
fn texts_of_old_systems_become_plain() {
    for (text, expected) in [
        (&b"\xef\xbb\xbfv 1\rf 2\r\x1a"[..], &b"v 1\nf 2\n"[..]),
        (b"v 1\r\nf 2\rf 3", b"v 1\r\nf 2\nf 3"),
        (b"v 1\r\r\nf 2\n\0\0", b"v 1\r\r\nf 2\n"),
        (b"\x1a", b""),
        (b"v\r", b"v\r"),
    ] {
        assert_eq!(&*plain(text), expected, "{text:?}");
    }
}

#[test]
#[cfg(feature = "obj")]
fn one_minus_is_lossless_both_ways() {
    let mut bits = 99u32;
    for _ in 0..20_000 {
        bits = bits.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let x = (bits >> 8) as f32 / (1u32 << 22) as f32 - 1.5;
        let mut text = Vec::new();
        push_one_minus_f32(&mut text, x);
        let back = Cursor::new(&text).number().unwrap().one_minus_f32();
        assert_eq!(back, x, "{}", String::from_utf8_lossy(&text));
    }
    let mut text = Vec::new();
    push_one_minus_f32(&mut text, Cursor::new(b"0.123456").number().unwrap().one_minus_f32());
    assert_eq!(text, b"0.123456");
}

#[test]
#[cfg(feature = "obj")]
fn a_backslash_joins_lines() {
    let mut cursor = Cursor::new(b"f 1 \\\n 2\\\r\n3\nv").with_continuation();
    assert_eq!(cursor.word(), b"f");
    assert_eq!([1, 2, 3], [(); 3].map(|()| cursor.integer().unwrap()));
    assert!(cursor.at_line_end());
    assert_eq!(cursor.line(), 3);
    cursor.next_line();
    assert_eq!((cursor.word(), cursor.line()), (&b"v"[..], 4));
}
