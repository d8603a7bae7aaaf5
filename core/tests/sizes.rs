//! The table of sizes in the README is what the compiler says, on machines with addresses of 64 bits.
#![cfg(target_pointer_width = "64")]
#![allow(missing_docs)]

use std::fmt::Write;

use hooke::{
    AdaptiveDop853, AdaptiveDormandPrinceRkn8, Auto, BlanesMoanS6, Compensated, DenseOutput, Dop853, DormandPrinceRkn8,
    ExplicitEuler, Fixed, ImplicitEuler, ImplicitEulerLinearised, ImplicitMidpoint, Ledger, Project, Real, Reflect,
    Rk4, SemiImplicitEuler, TimeOfImpact, TrBdf2, VelocityVerlet, World,
};

/// The capacity of the example.
type Example = Fixed<100, 200, 1>;

/// Bytes of whatever `of` measures, in each precision.
macro_rules! sizes {
    ($R:ident => $size:expr) => {{
        #[allow(clippy::extra_unused_type_parameters, reason = "some have no numbers in them")]
        fn size<$R: Real>() -> usize {
            $size
        }
        [size::<f32>(), size::<Compensated>(), size::<f64>()]
    }};
}

macro_rules! each {
    ($R:ident => $($type:ty,)*) => {
        [$((stringify!($type), sizes!($R => size_of::<$type>())),)*]
    };
}

/// What one more of something takes: a thousand more, shared among them, so that no padding counts.
fn marginal(small: [usize; 3], large: [usize; 3]) -> [usize; 3] {
    [0, 1, 2].map(|precision| (large[precision] - small[precision]) / 1024)
}

/// So many reals and bytes, in each precision.
fn reals(count: usize, residuals: usize, bytes: usize) -> [usize; 3] {
    [count * 4, (count + residuals) * 4, count * 8].map(|numbers| numbers + bytes)
}

#[test]
fn particles_springs_and_planes_take_what_they_are_made_of() {
    let empty = sizes!(R => size_of::<World<R, 1024, 1024, 1024>>());
    let particle = marginal(empty, sizes!(R => size_of::<World<R, 2048, 1024, 1024>>()));
    let spring = marginal(empty, sizes!(R => size_of::<World<R, 1024, 2048, 1024>>()));
    let plane = marginal(empty, sizes!(R => size_of::<World<R, 1024, 1024, 2048>>()));
    // Two states of position and velocity, mass and its inverse; three numbers of 32 bits and a mark.
    assert_eq!(particle, reals(2 * 6 + 2, 2 * 6, 3 * 4 + 1));
    // Stiffness, damping, rest length; as many bytes as the documentation of `World` says.
    assert_eq!(spring, reals(3, 0, 34));
    // A normal, an offset, a restitution.
    assert_eq!(plane, reals(3 + 1 + 1, 0, 0));
}

#[test]
fn the_table_of_sizes_is_right() {
    let empty = sizes!(R => size_of::<World<R, 1024, 1024, 1024>>());
    let mut rows = vec![
        ("a particle", marginal(empty, sizes!(R => size_of::<World<R, 2048, 1024, 1024>>()))),
        ("a spring", marginal(empty, sizes!(R => size_of::<World<R, 1024, 2048, 1024>>()))),
        ("a plane", marginal(empty, sizes!(R => size_of::<World<R, 1024, 1024, 2048>>()))),
        ("`World<R, 0, 0, 0>`", sizes!(R => size_of::<World<R, 0, 0, 0>>())),
        ("`World<R, 100, 200, 1>`", sizes!(R => size_of::<World<R, 100, 200, 1>>())),
    ];
    let workspaces = each!(R =>
        ExplicitEuler,
        SemiImplicitEuler,
        VelocityVerlet<R, Example>,
        Rk4<R, Example>,
        BlanesMoanS6<R, Example>,
        Dop853<R, Example>,
        DormandPrinceRkn8<R, Example>,
        AdaptiveDop853<R, Example>,
        AdaptiveDormandPrinceRkn8<R, Example>,
        DenseOutput<Dop853<R, Example>, R, Example>,
        ImplicitEuler<R, Example, 0>,
        ImplicitEuler<R, Example, 1>,
        ImplicitEulerLinearised<R, Example, 1>,
        ImplicitMidpoint<R, Example, 1>,
        TrBdf2<R, Example, 1>,
        Auto<R, Example, 1>,
        Reflect,
        Project,
        TimeOfImpact<R, Example>,
        Ledger,
    );
    let names = workspaces.map(|(name, _)| format!("`{}`", name.replace("Example", "M")));
    rows.extend(names.iter().map(String::as_str).zip(workspaces.map(|(_, bytes)| bytes)));
    let mut table = String::new();
    for (name, [single, compensated, double]) in rows {
        writeln!(table, "| {name} | {single} | {compensated} | {double} |").unwrap_or_default();
    }
    let readme = include_str!("../README.md");
    assert!(readme.contains(&table), "the table in README.md should be\n{table}");
}
