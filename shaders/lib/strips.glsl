// Layout of the strip sums: strip after strip, row after row, then a sum for each row.

uint stripsPerRow() { return (uint(frame.size.x) + uint(STRIP) - 1u) / uint(STRIP); }
uint stripIndex(ivec2 p) { return uint(p.y) * stripsPerRow() + uint(p.x / STRIP); }
uint rowIndex(uint row) { return uint(frame.size.y) * stripsPerRow() + row; }
