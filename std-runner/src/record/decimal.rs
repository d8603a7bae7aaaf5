//! The shorter of a number's plain and exponent forms.

use std::io::Write;

/// No finite `f64` takes more digits than this between its first and its last that isn't 0, with room to spare.
const MOST_DIGITS: usize = 32;
/// As in `e-324`.
const LONGEST_EXPONENT: usize = 5;

/// Appends a finite number in its shortest form. It is given as text of as few significant digits as it can have, with a
/// point or an exponent.
///
/// The forms are plain (`0.25`, `1200`) and whole digits with an exponent (`25e-7`, `12e9`); where they are equally
/// short, plain. A sign in front of 0 is kept.
pub(super) fn append_shortest(number: &[u8], text: &mut Vec<u8>) {
    let unsigned = match number.strip_prefix(b"-") {
        Some(rest) => {
            text.push(b'-');
            rest
        }
        None => number,
    };
    if is_short_already(unsigned) {
        text.extend_from_slice(unsigned);
        return;
    }
    let mut digits = [0; MOST_DIGITS];
    let (count, exponent) = take_apart(unsigned, &mut digits);
    append_parts(&digits[..count], exponent, text);
}

/// Whether a number is in plain form, with a fraction that isn't 0 and at most one 0 behind the point:
/// no exponent form of such a number is shorter. Nearly all coordinates are of this kind.
fn is_short_already(unsigned: &[u8]) -> bool {
    let end = &unsigned[unsigned.len().saturating_sub(LONGEST_EXPONENT)..];
    !unsigned.starts_with(b"0.00") && !unsigned.ends_with(b".0") && !end.contains(&b'e')
}

/// Digits without zeros at either end, how many they are, and the power of ten that they count.
fn take_apart(unsigned: &[u8], digits: &mut [u8; MOST_DIGITS]) -> (usize, i32) {
    let mut count = 0;
    let mut exponent = 0;
    let mut in_fraction = false;
    let mut bytes = unsigned.iter();
    for &byte in bytes.by_ref() {
        match byte {
            b'.' => in_fraction = true,
            b'e' => break,
            digit => {
                if count > 0 || digit != b'0' {
                    digits[count] = digit;
                    count += 1;
                }
                exponent -= i32::from(in_fraction);
            }
        }
    }
    exponent += read_exponent(bytes.as_slice());
    while count > 0 && digits[count - 1] == b'0' {
        count -= 1;
        exponent += 1;
    }
    (count, exponent)
}

/// What stands behind an `e`; 0 if nothing does.
fn read_exponent(text: &[u8]) -> i32 {
    let magnitude =
        text.iter().filter(|byte| byte.is_ascii_digit()).fold(0, |sum, digit| sum * 10 + i32::from(digit - b'0'));
    if text.starts_with(b"-") { -magnitude } else { magnitude }
}

fn append_parts(digits: &[u8], exponent: i32, text: &mut Vec<u8>) {
    let Some(count) = i32::try_from(digits.len()).ok().filter(|&count| count > 0) else {
        text.push(b'0');
        return;
    };
    // Where the point is: behind this many of the digits; before the first of them if it isn't more than 0.
    let point = count + exponent;
    let plain_length = if exponent >= 0 {
        point
    } else if point > 0 {
        count + 1
    } else {
        2 - point + count
    };
    let exponent_length = count + 1 + decimal_length(exponent);
    if exponent_length < plain_length {
        text.extend_from_slice(digits);
        // Writing to a `Vec` can't fail.
        let _ = write!(text, "e{exponent}");
    } else if exponent >= 0 {
        text.extend_from_slice(digits);
        append_zeros(exponent, text);
    } else if point > 0 {
        let (whole, fraction) = digits.split_at(usize::try_from(point).unwrap_or(0));
        text.extend_from_slice(whole);
        text.push(b'.');
        text.extend_from_slice(fraction);
    } else {
        text.extend_from_slice(b"0.");
        append_zeros(-point, text);
        text.extend_from_slice(digits);
    }
}

fn append_zeros(count: i32, text: &mut Vec<u8>) {
    text.resize(text.len() + usize::try_from(count).unwrap_or(0), b'0');
}

/// How many characters a whole number takes, its sign among them.
fn decimal_length(number: i32) -> i32 {
    let digits = match number.unsigned_abs() {
        0..10 => 1,
        10..100 => 2,
        _ => 3,
    };
    digits + i32::from(number < 0)
}
