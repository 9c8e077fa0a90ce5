//! SIMD instruction sets, found when the program runs.
//!
//! One source is compiled several times: a [`SimdKernel`] is written over a [`Level`], and [`Isa::run`] calls the copy that
//! was compiled for the widest instructions there are. Vectors are plain arrays, which the compiler puts into
//! registers; only what it does not find by itself, the mask of a comparison, is written with intrinsics.

#[cfg(target_arch = "x86_64")]
mod x86;

#[cfg(target_arch = "x86_64")]
use x86::{Avx2, Avx512};

use crate::probe::Probe;

/// An instruction set that this machine has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Isa(Set);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Set {
    Portable,
    #[cfg(target_arch = "x86_64")]
    Avx2(Avx2),
    #[cfg(target_arch = "x86_64")]
    Avx512(Avx512),
}

/// Something to do with whatever instructions there are.
pub trait SimdKernel {
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
    /// Plain loops, which round alike on every machine.
    const PORTABLE: Self = Self(Set::Portable);

    /// The widest of this machine.
    pub fn best() -> Self {
        Self::all().last().copied().unwrap_or(Self::PORTABLE)
    }

    /// These instructions, or plain loops if the probe records the steps: a fused multiply-add rounds once where others round
    /// twice, and what is recorded must have the same bits on every machine.
    #[inline(always)]
    pub fn unless_recorded<P: Probe>(self) -> Self {
        if P::TRAVERSAL { Self::PORTABLE } else { self }
    }

    /// All of this machine, the widest last.
    pub fn all() -> Vec<Self> {
        let mut all = vec![Self::PORTABLE];
        #[cfg(target_arch = "x86_64")]
        {
            all.extend(Avx2::found().map(|level| Self(Set::Avx2(level))));
            all.extend(Avx512::found().map(|level| Self(Set::Avx512(level))));
        }
        all
    }

    /// Does the kernel with these instructions.
    #[inline]
    pub fn run<T: SimdKernel>(self, kernel: T) -> T::Output {
        match self.0 {
            Set::Portable => kernel.run(Portable),
            #[cfg(target_arch = "x86_64")]
            Set::Avx2(level) => level.run(kernel),
            #[cfg(target_arch = "x86_64")]
            Set::Avx512(level) => level.run(kernel),
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

#[cfg(test)]
mod tests;
