//! The book's robot, described once: a Pioneer that collects specimens (tables 6.1 and 6.2).
//!
//! Simulator, firmware and budgets all use this description; it is also the example to copy.

crate::brain! {
    /// The forager with the book's maps of 20 × 20 nodes.
    pub mod pioneer {
        items: [s1, s2, s3, s4, s5, ingrip, bump],
        actions: [forward, backward, turnl, turnr, turnaround, grip],
        values: [ingrip = 10.0],
        maps: 20 x 20,
        patterns: 128,
        schemas: 704,
        synthetic: 384,
        beliefs: 3072,
        ram: 266_000,
    }
}

crate::brain! {
    /// The same robot with the brain for small parts: its life fills a quarter of the book's maps,
    /// and a byte is enough for a weight.
    pub mod small {
        items: [s1, s2, s3, s4, s5, ingrip, bump],
        actions: [forward, backward, turnl, turnr, turnaround, grip],
        values: [ingrip = 10.0],
        maps: 10 x 10 of bytes,
        patterns: 64,
        schemas: 512,
        synthetic: 384,
        beliefs: 3072,
        ram: 91_000,
    }
}
