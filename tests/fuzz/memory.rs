//! Memory, counted: an allocator that tells what one thread asks for.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    /// Bytes in use. A thread may give back what another one took: then it is below 0.
    static USED: Cell<isize> = const { Cell::new(0) };
    static PEAK: Cell<isize> = const { Cell::new(0) };
    static TOTAL: Cell<usize> = const { Cell::new(0) };
}

/// The system's allocator, with counters.
pub struct Counting;

/// What some work asked for, in bytes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Memory {
    /// The most at one time.
    pub peak: usize,
    /// All together: a measure of work, too.
    pub total: usize,
}

/// Does the work, and counts what this thread asks for meanwhile.
pub fn counted<T>(work: impl FnOnce() -> T) -> (T, Memory) {
    let (before, total) = (USED.get(), TOTAL.get());
    PEAK.set(before);
    let done = work();
    let memory = Memory {
        peak: PEAK.get().saturating_sub(before) as usize,
        total: TOTAL.get().wrapping_sub(total),
    };
    (done, memory)
}

fn more(bytes: usize) {
    let used = USED.get().wrapping_add_unsigned(bytes);
    USED.set(used);
    PEAK.set(PEAK.get().max(used));
    TOTAL.set(TOTAL.get().wrapping_add(bytes));
}

fn less(bytes: usize) {
    USED.set(USED.get().wrapping_sub_unsigned(bytes));
}

#[expect(
    unsafe_code,
    reason = "an allocator is unsafe by its nature; this one only counts"
)]
// SAFETY: every call is handed on to the system's allocator as it came.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        more(layout.size());
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        less(layout.size());
        unsafe { System.dealloc(place, layout) }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        more(layout.size());
        unsafe { System.alloc_zeroed(layout) }
    }

    unsafe fn realloc(&self, place: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // At the worst the old and the new piece exist together for a moment.
        more(size);
        less(layout.size());
        unsafe { System.realloc(place, layout, size) }
    }
}

#[test]
fn memory_is_counted() {
    let (list, memory) = counted(|| {
        drop(Vec::<u8>::with_capacity(1000));
        Vec::<u8>::with_capacity(300)
    });
    assert_eq!((memory.peak, memory.total), (1000, 1300));
    let ((), grown) = counted(|| {
        let mut list = list;
        list.reserve_exact(400);
    });
    assert_eq!((grown.peak, grown.total), (400, 400));
}
