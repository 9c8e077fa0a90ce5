//! The instruction set of the machine at hand, found when the program runs.
//!
//! One source is compiled several times: a [`Task`] is written over a [`Level`], and [`Isa::run`] calls the copy that
//! was compiled for the widest instructions there are. Vectors are plain arrays, which the compiler puts into
//! registers; only what it does not find by itself, the mask of a comparison, is written with intrinsics.
//!
//! This is the one file with `unsafe` code. Its reason is always the same: a function that was compiled for an
//! instruction set may only run where that set exists. An [`Isa`] and the levels below can be made nowhere else, and
//! here only after the processor was asked.
#![allow(unsafe_code)]

/// An instruction set that this machine has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Isa(Set);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Set {
    Portable,
    #[cfg(target_arch = "x86_64")]
    Avx2,
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

/// Something to do with whatever instructions there are.
pub trait Task {
    /// What comes of it.
    type Output;

    /// Does it. Implementations are `#[inline(always)]`, so that they are compiled for the level.
    fn run<L: Level>(self, level: L) -> Self::Output;
}

/// What differs between instruction sets. Most methods are element-wise comparisons, bit i telling of element i; NaN
/// compares as false.
pub trait Level: Copy {
    /// Whether a fused multiply-add is one instruction.
    const FUSED: bool;

    /// a <= b.
    fn le4(self, a: &[f32; 4], b: &[f32; 4]) -> u32;

    /// a <= b.
    fn le8(self, a: &[f32; 8], b: &[f32; 8]) -> u32;

    /// a <= b.
    fn le16(self, a: &[f32; 16], b: &[f32; 16]) -> u32;

    /// 0 <= a.
    fn positive8(self, a: &[f64; 8]) -> u32;

    /// a < b.
    fn less8(self, a: &[f64; 8], b: &[f64; 8]) -> u32;

    /// The smaller of each two elements; the second if one is NaN.
    #[inline(always)]
    fn min16(self, a: &[f32; 16], b: &[f32; 16]) -> [f32; 16] {
        let mut out = *b;
        for (out, &a) in out.iter_mut().zip(a) {
            *out = if a < *out { a } else { *out };
        }
        out
    }

    /// The larger of each two elements; the second if one is NaN.
    #[inline(always)]
    fn max16(self, a: &[f32; 16], b: &[f32; 16]) -> [f32; 16] {
        let mut out = *b;
        for (out, &a) in out.iter_mut().zip(a) {
            *out = if a > *out { a } else { *out };
        }
        out
    }

    /// a b - c of each element, with one rounding or two.
    #[inline(always)]
    fn multiply_subtract16(self, a: f32, b: &[f32; 16], c: &[f32; 16]) -> [f32; 16] {
        let mut out = [0.0; 16];
        for i in 0..16 {
            out[i] = self.multiply_subtract(a, b[i], c[i]);
        }
        out
    }

    /// a b - c, with one rounding or two.
    #[inline(always)]
    fn multiply_subtract(self, a: f32, b: f32, c: f32) -> f32 {
        if Self::FUSED {
            a.mul_add(b, -c)
        } else {
            a * b - c
        }
    }
}

impl Isa {
    /// The widest of this machine.
    pub fn best() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            if has_avx512() {
                return Self(Set::Avx512);
            }
            if has_avx2() {
                return Self(Set::Avx2);
            }
        }
        Self(Set::Portable)
    }

    /// All of this machine, for the test that they agree.
    #[cfg(test)]
    pub fn all() -> Vec<Self> {
        let mut all = vec![Self(Set::Portable)];
        #[cfg(target_arch = "x86_64")]
        {
            if has_avx2() {
                all.push(Self(Set::Avx2));
            }
            if has_avx512() {
                all.push(Self(Set::Avx512));
            }
        }
        all
    }

    /// Does the task with these instructions.
    #[inline]
    pub fn run<T: Task>(self, task: T) -> T::Output {
        match self.0 {
            Set::Portable => task.run(Portable),
            // SAFETY: such an `Isa` is only made after the processor said that it has these instructions.
            #[cfg(target_arch = "x86_64")]
            Set::Avx2 => unsafe { with_avx2(task) },
            // SAFETY: the same.
            #[cfg(target_arch = "x86_64")]
            Set::Avx512 => unsafe { with_avx512(task) },
        }
    }
}

/// Plain loops.
#[derive(Clone, Copy)]
struct Portable;

/// Bit i tells whether the comparison holds for element i.
#[inline(always)]
fn bits<const N: usize>(holds: impl Fn(usize) -> bool) -> u32 {
    (0..N).fold(0, |mask, i| mask | u32::from(holds(i)) << i)
}

impl Level for Portable {
    const FUSED: bool = false;

    #[inline(always)]
    fn le4(self, a: &[f32; 4], b: &[f32; 4]) -> u32 {
        bits::<4>(|i| a[i] <= b[i])
    }

    #[inline(always)]
    fn le8(self, a: &[f32; 8], b: &[f32; 8]) -> u32 {
        bits::<8>(|i| a[i] <= b[i])
    }

    #[inline(always)]
    fn le16(self, a: &[f32; 16], b: &[f32; 16]) -> u32 {
        bits::<16>(|i| a[i] <= b[i])
    }

    #[inline(always)]
    fn positive8(self, a: &[f64; 8]) -> u32 {
        bits::<8>(|i| a[i] >= 0.0)
    }

    #[inline(always)]
    fn less8(self, a: &[f64; 8], b: &[f64; 8]) -> u32 {
        bits::<8>(|i| a[i] < b[i])
    }
}

#[cfg(target_arch = "x86_64")]
use x86::{has_avx2, has_avx512, with_avx2, with_avx512};

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{Level, Task};
    use std::arch::x86_64::{
        _CMP_GE_OQ, _CMP_LE_OQ, _CMP_LT_OQ, _mm_cmple_ps, _mm_loadu_ps, _mm_movemask_ps,
        _mm256_cmp_pd, _mm256_cmp_ps, _mm256_fmsub_ps, _mm256_loadu_pd, _mm256_loadu_ps,
        _mm256_max_ps, _mm256_min_ps, _mm256_movemask_pd, _mm256_movemask_ps, _mm256_set1_ps,
        _mm256_setzero_pd, _mm256_storeu_ps, _mm512_cmp_pd_mask, _mm512_cmp_ps_mask,
        _mm512_fmsub_ps, _mm512_loadu_pd, _mm512_loadu_ps, _mm512_max_ps, _mm512_min_ps,
        _mm512_set1_ps, _mm512_setzero_pd, _mm512_storeu_ps,
    };

    pub fn has_avx2() -> bool {
        is_x86_feature_detected!("avx2")
            && is_x86_feature_detected!("fma")
            && is_x86_feature_detected!("bmi1")
            && is_x86_feature_detected!("bmi2")
    }

    pub fn has_avx512() -> bool {
        has_avx2()
            && is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("avx512bw")
            && is_x86_feature_detected!("avx512vl")
    }

    #[target_feature(enable = "avx2,fma,bmi1,bmi2")]
    pub fn with_avx2<T: Task>(task: T) -> T::Output {
        task.run(Avx2(()))
    }

    #[target_feature(enable = "avx2,fma,bmi1,bmi2,avx512f,avx512dq,avx512bw,avx512vl")]
    pub fn with_avx512<T: Task>(task: T) -> T::Output {
        task.run(Avx512(()))
    }

    /// 256 bits.
    #[derive(Clone, Copy)]
    pub struct Avx2(());

    /// 512 bits.
    #[derive(Clone, Copy)]
    pub struct Avx512(());

    // SAFETY, for every block below: `Avx2` is only made in `with_avx2`, `Avx512` only in `with_avx512`, so the
    // instructions exist; and each load and store is of an array of just its length.
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
            let (a, b, mut out) = (a.as_chunks::<8>().0, b.as_chunks::<8>().0, [0.0; 16]);
            for (k, out) in out.as_chunks_mut::<8>().0.iter_mut().enumerate() {
                unsafe {
                    let (a, b) = (
                        _mm256_loadu_ps(a[k].as_ptr()),
                        _mm256_loadu_ps(b[k].as_ptr()),
                    );
                    _mm256_storeu_ps(out.as_mut_ptr(), _mm256_min_ps(a, b));
                }
            }
            out
        }

        #[inline(always)]
        fn max16(self, a: &[f32; 16], b: &[f32; 16]) -> [f32; 16] {
            let (a, b, mut out) = (a.as_chunks::<8>().0, b.as_chunks::<8>().0, [0.0; 16]);
            for (k, out) in out.as_chunks_mut::<8>().0.iter_mut().enumerate() {
                unsafe {
                    let (a, b) = (
                        _mm256_loadu_ps(a[k].as_ptr()),
                        _mm256_loadu_ps(b[k].as_ptr()),
                    );
                    _mm256_storeu_ps(out.as_mut_ptr(), _mm256_max_ps(a, b));
                }
            }
            out
        }

        #[inline(always)]
        fn multiply_subtract16(self, a: f32, b: &[f32; 16], c: &[f32; 16]) -> [f32; 16] {
            let (b, c, mut out) = (b.as_chunks::<8>().0, c.as_chunks::<8>().0, [0.0; 16]);
            for (k, out) in out.as_chunks_mut::<8>().0.iter_mut().enumerate() {
                unsafe {
                    let (b, c) = (
                        _mm256_loadu_ps(b[k].as_ptr()),
                        _mm256_loadu_ps(c[k].as_ptr()),
                    );
                    let t = _mm256_fmsub_ps(_mm256_set1_ps(a), b, c);
                    _mm256_storeu_ps(out.as_mut_ptr(), t);
                }
            }
            out
        }
    }

    // Methods, not closures: a closure is compiled without the instructions first, and then not inlined.
    impl Avx2 {
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
            let mut out = [0.0; 16];
            unsafe {
                let (a, b) = (_mm512_loadu_ps(a.as_ptr()), _mm512_loadu_ps(b.as_ptr()));
                _mm512_storeu_ps(out.as_mut_ptr(), _mm512_min_ps(a, b));
            }
            out
        }

        #[inline(always)]
        fn max16(self, a: &[f32; 16], b: &[f32; 16]) -> [f32; 16] {
            let mut out = [0.0; 16];
            unsafe {
                let (a, b) = (_mm512_loadu_ps(a.as_ptr()), _mm512_loadu_ps(b.as_ptr()));
                _mm512_storeu_ps(out.as_mut_ptr(), _mm512_max_ps(a, b));
            }
            out
        }

        #[inline(always)]
        fn multiply_subtract16(self, a: f32, b: &[f32; 16], c: &[f32; 16]) -> [f32; 16] {
            let mut out = [0.0; 16];
            unsafe {
                let (b, c) = (_mm512_loadu_ps(b.as_ptr()), _mm512_loadu_ps(c.as_ptr()));
                let t = _mm512_fmsub_ps(_mm512_set1_ps(a), b, c);
                _mm512_storeu_ps(out.as_mut_ptr(), t);
            }
            out
        }
    }
}

#[cfg(test)]
mod tests;
