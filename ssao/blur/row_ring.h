// The rows of a map that are still needed, while a sweep goes down it.
#pragma once

#include <array>

#include "rasterizer/base/image.h"

namespace crevice {

// Row y stands in place of row y - capacity. At both ends of a row lie kRowAlignment elements more, so that whoever reads a
// little beside a row needs no test of its position.
template <class T>
class RowRing {
 public:
    RowRing(int width, int capacity, T fill)
        : capacity_(capacity), rows_({kApron + width + kApron, capacity}, fill) {}

    // Element 0 of row y; y >= -capacity.
    T* row(int y) { return at_place((y + capacity_) % capacity_); }
    // The same of `kCount` rows from y on.
    template <int kCount>
    std::array<const T*, kCount> rows(int y) {
        std::array<const T*, kCount> result;
        int place = (y + capacity_) % capacity_;
        for (const T*& row : result) {
            row = at_place(place);
            place = place + 1 < capacity_ ? place + 1 : 0;
        }
        return result;
    }

 private:
    static constexpr int kApron = kRowAlignment;
    T* at_place(int place) { return rows_.row(place) + kApron; }

    int capacity_;
    Image<T> rows_;
};

}  // namespace crevice
