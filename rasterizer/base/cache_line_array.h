// An array that begins at a cache line, so that no group of pixels lies on two of them: tiles of planes that straddle lines
// take three times as long to write. New elements are left as they are, so that a pass can fill a large image tile by tile,
// on all threads; and nothing is done to elements that go, where std::vector with an allocator of one's own walks over all
// of them unless the optimizer sees that it is for nothing (below -O2 it does not, which was 6 % of a frame).
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace crevice {

template <class T>
class CacheLineArray {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
    using value_type = T;

    CacheLineArray() = default;
    explicit CacheLineArray(std::size_t size) { resize(size); }
    CacheLineArray(const CacheLineArray& other) : CacheLineArray(other.size_) {
        std::copy(other.begin(), other.end(), begin());
    }
    CacheLineArray(CacheLineArray&& other) noexcept { swap(other); }
    CacheLineArray& operator=(CacheLineArray other) noexcept {
        swap(other);
        return *this;
    }
    ~CacheLineArray() { ::operator delete(first_, kCacheLine); }

    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T* data() { return first_; }
    const T* data() const { return first_; }
    T* begin() { return first_; }
    const T* begin() const { return first_; }
    T* end() { return first_ + size_; }
    const T* end() const { return first_ + size_; }
    T& operator[](std::size_t i) { return first_[i]; }
    const T& operator[](std::size_t i) const { return first_[i]; }
    const T& front() const { return *first_; }

    // Makes room, so that it grows to `capacity` without moving. Throws std::bad_alloc.
    void reserve(std::size_t capacity) {
        if (capacity <= capacity_) return;
        if (capacity > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
        T* const moved = static_cast<T*>(::operator new(capacity * sizeof(T), kCacheLine));
        std::copy(begin(), end(), moved);
        ::operator delete(first_, kCacheLine);
        first_ = moved;
        capacity_ = capacity;
    }
    // New elements hold anything, or what their members' initializers say.
    void resize(std::size_t size) {
        reserve(size);
        if (size > size_) std::uninitialized_default_construct(end(), first_ + size);
        size_ = size;
    }
    // One more, to be written.
    T& add() {
        if (size_ == capacity_) reserve(std::max(2 * capacity_, kLeastCapacity));
        resize(size_ + 1);
        return first_[size_ - 1];
    }

    friend bool operator==(const CacheLineArray& a, const CacheLineArray& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    }

 private:
    static constexpr std::align_val_t kCacheLine{64};
    static constexpr std::size_t kLeastCapacity = 8;

    void swap(CacheLineArray& other) noexcept {
        std::swap(first_, other.first_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
    }

    T* first_ = nullptr;
    std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace crevice
