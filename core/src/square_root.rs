//! The square root of the machine: one instruction wherever the target has one, and one that loops vectorise.
//!
//! Every form gives the correctly rounded root, so which of them is taken never shows in the bits.
#![allow(unsafe_code, reason = "an instruction that `core` has no safe name for")]

cfg_select! {
    feature = "std" => {
        /// √x in single precision.
        #[inline(always)]
        pub fn single(x: f32) -> f32 {
            x.sqrt()
        }

        /// √x in double precision.
        #[inline(always)]
        pub fn double(x: f64) -> f64 {
            x.sqrt()
        }
    }
    all(target_arch = "x86_64", target_feature = "sse2") => {
        use core::arch::x86_64::{_mm_cvtsd_f64, _mm_cvtss_f32, _mm_set_sd, _mm_set_ss, _mm_sqrt_sd, _mm_sqrt_ss};

        /// √x in single precision.
        #[inline(always)]
        pub fn single(x: f32) -> f32 {
            // SAFETY: SSE is there, as SSE2 implies it.
            unsafe { _mm_cvtss_f32(_mm_sqrt_ss(_mm_set_ss(x))) }
        }

        /// √x in double precision.
        #[inline(always)]
        pub fn double(x: f64) -> f64 {
            // SAFETY: SSE2 is there.
            unsafe {
                let lanes = _mm_set_sd(x);
                _mm_cvtsd_f64(_mm_sqrt_sd(lanes, lanes))
            }
        }
    }
    all(target_arch = "aarch64", target_feature = "neon") => {
        use core::arch::aarch64::{vdup_n_f32, vdup_n_f64, vget_lane_f32, vget_lane_f64, vsqrt_f32, vsqrt_f64};

        /// √x in single precision.
        #[inline(always)]
        pub fn single(x: f32) -> f32 {
            // SAFETY: NEON is there.
            unsafe { vget_lane_f32::<0>(vsqrt_f32(vdup_n_f32(x))) }
        }

        /// √x in double precision.
        #[inline(always)]
        pub fn double(x: f64) -> f64 {
            // SAFETY: NEON is there.
            unsafe { vget_lane_f64::<0>(vsqrt_f64(vdup_n_f64(x))) }
        }
    }
    all(target_arch = "wasm32", target_feature = "simd128") => {
        use core::arch::wasm32::{
            f32x4_extract_lane, f32x4_splat, f32x4_sqrt, f64x2_extract_lane, f64x2_splat, f64x2_sqrt,
        };

        /// √x in single precision.
        #[inline(always)]
        pub fn single(x: f32) -> f32 {
            f32x4_extract_lane::<0>(f32x4_sqrt(f32x4_splat(x)))
        }

        /// √x in double precision.
        #[inline(always)]
        pub fn double(x: f64) -> f64 {
            f64x2_extract_lane::<0>(f64x2_sqrt(f64x2_splat(x)))
        }
    }
    target_arch = "wasm32" => {
        // `core` has no stable name for `f32.sqrt`. The compiler puts the instruction in place of a call of C's
        // function where it can tell that the argument is not negative: C's would report that in `errno`. Where it
        // does not optimise, the call remains; the function is in the library that comes with every compiler.
        //
        // SAFETY: these are C's functions of that name and type; they read and write no memory but `errno`.
        unsafe extern "C" {
            safe fn sqrtf(x: f32) -> f32;
            safe fn sqrt(x: f64) -> f64;
        }

        /// √x in single precision.
        #[inline(always)]
        pub fn single(x: f32) -> f32 {
            // √−0 is −0.
            let root = sqrtf(x.abs()).copysign(x);
            if x < 0.0 { f32::NAN } else { root }
        }

        /// √x in double precision.
        #[inline(always)]
        pub fn double(x: f64) -> f64 {
            let root = sqrt(x.abs()).copysign(x);
            if x < 0.0 { f64::NAN } else { root }
        }
    }
    all(target_arch = "arm", target_abi = "eabihf") => {
        use core::arch::asm;

        pub use libm::sqrt as double;

        /// √x in single precision.
        ///
        /// This ABI passes numbers in the registers of a floating-point unit: there is one, of single precision at
        /// least. Whether of double, as on a Cortex-M7 and not on a Cortex-M4, is hidden from stable Rust.
        #[inline(always)]
        pub fn single(x: f32) -> f32 {
            let root: u32;
            // SAFETY: reads and writes the named registers alone. They are core registers because `asm!` refuses
            // floating-point operands for this target.
            unsafe {
                asm!(
                    "vmov s0, {x}",
                    "vsqrt.f32 s0, s0",
                    "vmov {x}, s0",
                    x = inlateout(reg) x.to_bits() => root,
                    out("s0") _,
                    options(pure, nomem, nostack),
                );
            }
            f32::from_bits(root)
        }
    }
    _ => {
        pub use libm::{sqrt as double, sqrtf as single};
    }
}
