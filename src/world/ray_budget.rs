//! Ray budget of a pixel: the one place where rays are counted.

/// Rays that a pixel has sent, and what it may still spend.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayBudget {
    /// Rays sent, eye rays included.
    pub sent: u64,
    /// What counts against the limit: all rays but eye rays, and light samples that needed no ray, since they cost time, too.
    pub used: u64,
    /// True if a ray was left out only because of a limit: the picture is not what was asked for.
    pub truncated: bool,
    limit: u64,
}

impl RayBudget {
    /// A budget of `limit` rays besides eye rays, of which none is used.
    pub fn new(limit: u64) -> Self {
        Self {
            limit,
            ..Self::default()
        }
    }

    /// True, and noted, if nothing is left.
    #[inline]
    pub fn is_spent(&mut self) -> bool {
        let spent = self.used >= self.limit;
        self.truncated |= spent;
        spent
    }

    /// What is left.
    pub fn left(&self) -> u64 {
        self.limit.saturating_sub(self.used)
    }

    /// Counts an eye ray, which is free.
    #[inline]
    pub fn eye_ray(&mut self) {
        self.sent += 1;
    }

    /// Counts a secondary ray, or a surface that a ray passes, which costs as much.
    #[inline]
    pub fn ray(&mut self) {
        self.sent += 1;
        self.used += 1;
    }

    /// Counts a light sample, with or without a shadow ray.
    #[inline]
    pub fn light_sample(&mut self, with_ray: bool) {
        self.sent += u64::from(with_ray);
        self.used += 1;
    }
}
