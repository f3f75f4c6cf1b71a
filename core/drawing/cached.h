#pragma once
// A value beside what it was made of, made again only where that has changed.

#include <optional>
#include <utility>

namespace dapple {

template <class Key, class Value>
class Cached {
 public:
    /// The value for that key. If another one is kept, it is given up, so that its memory can be used, and
    /// then make() makes this one.
    template <class Make>
    const Value& of(const Key& key, const Make& make) {
        if (!find(key)) {
            forget();
            keep(key, make());
        }
        return *value_;
    }

    /// Null if none is kept for that key.
    const Value* find(const Key& key) const { return key_ && *key_ == key ? &*value_ : nullptr; }

    /// The one that is kept, whatever its key; there has to be one.
    const Value& value() const { return *value_; }

    void keep(Key key, Value value) {
        value_ = std::move(value);
        key_ = std::move(key);
    }

    void forget() {
        key_.reset();
        value_.reset();
    }

 private:
    std::optional<Key> key_;
    std::optional<Value> value_;
};

}  // namespace dapple
