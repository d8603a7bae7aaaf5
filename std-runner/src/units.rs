//! Numbers as people read them, with their units.

/// `1 234 567`, by thousands.
pub(crate) fn count(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) && digits.len() > 4 {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// `1 spring`, `2 springs`.
pub(crate) fn counted(number: u64, what: &str) -> String {
    format!("{} {what}{}", count(number), if number == 1 { "" } else { "s" })
}

/// Four digits at most, without zeros at the end.
pub(crate) fn short(value: f64) -> String {
    let whole_digits = if value.abs() >= 1.0 { value.abs().log10().floor() as i32 + 1 } else { 1 };
    let decimals = usize::try_from(4 - whole_digits).unwrap_or(0);
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// With the prefix that leaves one to three digits before the point.
fn prefixed(value: f64, unit: &str, prefixes: &[(f64, &str)]) -> String {
    let size = value.abs();
    // What rounds up to a thousand belongs to the next prefix.
    let fitting = prefixes.iter().find(|(factor, _)| size >= 0.999_95 * factor);
    match fitting {
        Some((factor, prefix)) if size < 1e9 => format!("{} {prefix}{unit}", short(value / factor)),
        _ if size == 0.0 => format!("0 {unit}"),
        _ => format!("{value:.3e} {unit}"),
    }
}

/// `1.5 ms`, `20 s`.
pub(crate) fn seconds(value: f64) -> String {
    prefixed(value, "s", &[(1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n")])
}

/// `1.5 mm`, `20 m`, `3 km`.
pub(crate) fn metres(value: f64) -> String {
    prefixed(value, "m", &[(1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"), (1e-12, "p"), (1e-15, "f")])
}

/// `3 times`, `1.02 times`.
pub(crate) fn times(ratio: f64) -> String {
    if ratio < 1e6 { format!("{} times", short(ratio)) } else { format!("{ratio:.1e} times") }
}

/// `1.5 GB`, by thousands.
pub(crate) fn bytes(number: u128) -> String {
    let mut amount = number as f64;
    for unit in ["bytes", "kB", "MB", "GB", "TB"] {
        if amount < 999.95 {
            return format!("{} {unit}", short(amount));
        }
        amount /= 1000.0;
    }
    format!("{} PB", short(amount))
}

/// `1.5 mJ`, `20 J`.
pub(crate) fn joules(value: f64) -> String {
    prefixed(value, "J", &[(1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"), (1e-12, "p"), (1e-15, "f")])
}

/// `1.5 mm/s`, `20 m/s`.
pub(crate) fn metres_per_second(value: f64) -> String {
    format!("{}/s", metres(value))
}

/// `10⁴`, for powers of ten; other numbers as they are.
pub(crate) fn power_of_ten(value: f64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let exponent = value.log10();
    if exponent < 0.0 || (exponent - exponent.round()).abs() > 1e-6 {
        return short(value);
    }
    let digits = (exponent.round() as u32).to_string();
    let raised = digits.chars().filter_map(|digit| DIGITS.get(digit.to_digit(10)? as usize));
    format!("10{}", raised.collect::<String>())
}
