//! SIMD levels of x86: AVX2 and AVX-512.
//!
//! This is the one file with `unsafe` code. Its reason is always the same: an instruction may only run where it exists.
//! The values of [`Avx2`] and [`Avx512`] can be made only here, after the processor was queried, and every method takes
//! one. And each load and store is of an array of just its length.
//!
//! Operations are methods and macros, never closures: a closure is compiled without the instructions first, and then
//! not inlined.
#![allow(unsafe_code)]

use super::{Level, SimdKernel};
use std::arch::x86_64::{
    _CMP_GE_OQ, _CMP_LE_OQ, _CMP_LT_OQ, _mm_cmple_ps, _mm_loadu_ps, _mm_movemask_ps, _mm256_cmp_pd,
    _mm256_cmp_ps, _mm256_fmsub_ps, _mm256_loadu_pd, _mm256_loadu_ps, _mm256_max_ps, _mm256_min_ps,
    _mm256_movemask_pd, _mm256_movemask_ps, _mm256_set1_ps, _mm256_setzero_pd, _mm256_storeu_ps,
    _mm512_cmp_pd_mask, _mm512_cmp_ps_mask, _mm512_fmsub_ps, _mm512_loadu_pd, _mm512_loadu_ps,
    _mm512_max_ps, _mm512_min_ps, _mm512_set1_ps, _mm512_setzero_pd, _mm512_storeu_ps,
};

/// An operation on two rows of sixteen, eight at a time.
macro_rules! by_halves {
    (|$a:ident, $b:ident| $operation:expr) => {{
        let (a, b, mut out) = ($a.as_chunks::<8>().0, $b.as_chunks::<8>().0, [0.0; 16]);
        for (k, out) in out.as_chunks_mut::<8>().0.iter_mut().enumerate() {
            unsafe {
                let $a = _mm256_loadu_ps(a[k].as_ptr());
                let $b = _mm256_loadu_ps(b[k].as_ptr());
                _mm256_storeu_ps(out.as_mut_ptr(), $operation);
            }
        }
        out
    }};
}

/// An operation on two rows of sixteen, all at once.
macro_rules! at_once {
    (|$a:ident, $b:ident| $operation:expr) => {{
        let mut out = [0.0; 16];
        unsafe {
            let ($a, $b) = (_mm512_loadu_ps($a.as_ptr()), _mm512_loadu_ps($b.as_ptr()));
            _mm512_storeu_ps(out.as_mut_ptr(), $operation);
        }
        out
    }};
}

/// 256 bits: there is one only where the processor has AVX2 and FMA.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Avx2(());

/// 512 bits: there is one only where the processor has AVX-512.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Avx512(());

impl Avx2 {
    /// The level, if this machine has it.
    pub fn found() -> Option<Self> {
        let has = is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("fma")
            && is_x86_feature_detected!("bmi1")
            && is_x86_feature_detected!("bmi2");
        has.then_some(Self(()))
    }

    /// Does the kernel with these instructions.
    #[inline]
    pub fn run<T: SimdKernel>(self, kernel: T) -> T::Output {
        // SAFETY: there is a `self`, so `found` saw all features that the function is compiled for.
        unsafe { with_avx2(self, kernel) }
    }

    #[inline(always)]
    fn positive4(_: Self, a: &[f64; 4]) -> u32 {
        unsafe {
            let a = _mm256_loadu_pd(a.as_ptr());
            let holds = _mm256_cmp_pd::<_CMP_GE_OQ>(a, _mm256_setzero_pd());
            _mm256_movemask_pd(holds).cast_unsigned()
        }
    }

    #[inline(always)]
    fn less4(_: Self, a: &[f64; 4], b: &[f64; 4]) -> u32 {
        unsafe {
            let (a, b) = (_mm256_loadu_pd(a.as_ptr()), _mm256_loadu_pd(b.as_ptr()));
            _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(a, b)).cast_unsigned()
        }
    }
}

impl Avx512 {
    /// The level, if this machine has it.
    pub fn found() -> Option<Self> {
        let has = Avx2::found().is_some()
            && is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("avx512bw")
            && is_x86_feature_detected!("avx512vl");
        has.then_some(Self(()))
    }

    /// Does the kernel with these instructions.
    #[inline]
    pub fn run<T: SimdKernel>(self, kernel: T) -> T::Output {
        // SAFETY: as for `Avx2`.
        unsafe { with_avx512(self, kernel) }
    }
}

#[target_feature(enable = "avx2,fma,bmi1,bmi2")]
fn with_avx2<T: SimdKernel>(level: Avx2, kernel: T) -> T::Output {
    kernel.run(level)
}

#[target_feature(enable = "avx2,fma,bmi1,bmi2,avx512f,avx512dq,avx512bw,avx512vl")]
fn with_avx512<T: SimdKernel>(level: Avx512, kernel: T) -> T::Output {
    kernel.run(level)
}

impl Level for Avx2 {
    const FUSED: bool = true;

    #[inline(always)]
    fn le4(self, a: &[f32; 4], b: &[f32; 4]) -> u32 {
        unsafe {
            let (a, b) = (_mm_loadu_ps(a.as_ptr()), _mm_loadu_ps(b.as_ptr()));
            _mm_movemask_ps(_mm_cmple_ps(a, b)).cast_unsigned()
        }
    }

    #[inline(always)]
    fn le8(self, a: &[f32; 8], b: &[f32; 8]) -> u32 {
        unsafe {
            let (a, b) = (_mm256_loadu_ps(a.as_ptr()), _mm256_loadu_ps(b.as_ptr()));
            _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b)).cast_unsigned()
        }
    }

    #[inline(always)]
    fn le16(self, a: &[f32; 16], b: &[f32; 16]) -> u32 {
        let (a, b) = (a.as_chunks::<8>().0, b.as_chunks::<8>().0);
        self.le8(&a[0], &b[0]) | self.le8(&a[1], &b[1]) << 8
    }

    #[inline(always)]
    fn positive8(self, a: &[f64; 8]) -> u32 {
        let a = a.as_chunks::<4>().0;
        Self::positive4(self, &a[0]) | Self::positive4(self, &a[1]) << 4
    }

    #[inline(always)]
    fn less8(self, a: &[f64; 8], b: &[f64; 8]) -> u32 {
        let (a, b) = (a.as_chunks::<4>().0, b.as_chunks::<4>().0);
        Self::less4(self, &a[0], &b[0]) | Self::less4(self, &a[1], &b[1]) << 4
    }

    #[inline(always)]
    fn min16(self, a: &[f32; 16], b: &[f32; 16]) -> [f32; 16] {
        by_halves!(|a, b| _mm256_min_ps(a, b))
    }

    #[inline(always)]
    fn max16(self, a: &[f32; 16], b: &[f32; 16]) -> [f32; 16] {
        by_halves!(|a, b| _mm256_max_ps(a, b))
    }

    #[inline(always)]
    fn multiply_subtract16(self, a: f32, b: &[f32; 16], c: &[f32; 16]) -> [f32; 16] {
        by_halves!(|b, c| _mm256_fmsub_ps(_mm256_set1_ps(a), b, c))
    }
}

impl Level for Avx512 {
    const FUSED: bool = true;

    #[inline(always)]
    fn le4(self, a: &[f32; 4], b: &[f32; 4]) -> u32 {
        unsafe {
            let (a, b) = (_mm_loadu_ps(a.as_ptr()), _mm_loadu_ps(b.as_ptr()));
            _mm_movemask_ps(_mm_cmple_ps(a, b)).cast_unsigned()
        }
    }

    #[inline(always)]
    fn le8(self, a: &[f32; 8], b: &[f32; 8]) -> u32 {
        unsafe {
            let (a, b) = (_mm256_loadu_ps(a.as_ptr()), _mm256_loadu_ps(b.as_ptr()));
            _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(a, b)).cast_unsigned()
        }
    }

    #[inline(always)]
    fn le16(self, a: &[f32; 16], b: &[f32; 16]) -> u32 {
        unsafe {
            let (a, b) = (_mm512_loadu_ps(a.as_ptr()), _mm512_loadu_ps(b.as_ptr()));
            u32::from(_mm512_cmp_ps_mask::<_CMP_LE_OQ>(a, b))
        }
    }

    #[inline(always)]
    fn positive8(self, a: &[f64; 8]) -> u32 {
        unsafe {
            let a = _mm512_loadu_pd(a.as_ptr());
            u32::from(_mm512_cmp_pd_mask::<_CMP_GE_OQ>(a, _mm512_setzero_pd()))
        }
    }

    #[inline(always)]
    fn less8(self, a: &[f64; 8], b: &[f64; 8]) -> u32 {
        unsafe {
            let (a, b) = (_mm512_loadu_pd(a.as_ptr()), _mm512_loadu_pd(b.as_ptr()));
            u32::from(_mm512_cmp_pd_mask::<_CMP_LT_OQ>(a, b))
        }
    }

    #[inline(always)]
    fn min16(self, a: &[f32; 16], b: &[f32; 16]) -> [f32; 16] {
        at_once!(|a, b| _mm512_min_ps(a, b))
    }

    #[inline(always)]
    fn max16(self, a: &[f32; 16], b: &[f32; 16]) -> [f32; 16] {
        at_once!(|a, b| _mm512_max_ps(a, b))
    }

    #[inline(always)]
    fn multiply_subtract16(self, a: f32, b: &[f32; 16], c: &[f32; 16]) -> [f32; 16] {
        at_once!(|b, c| _mm512_fmsub_ps(_mm512_set1_ps(a), b, c))
    }
}
