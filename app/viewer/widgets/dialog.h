#pragma once
// A small dialog in the middle of the window, above all else.

namespace dapple {

/// Open while it lives and is true:
///
///     if (const Dialog dialog("Keys", open); dialog) { ... }
///
/// Its cross, Escape and a click beside it set `open` to false.
class Dialog {
 public:
    Dialog(const char* title, bool& open);
    ~Dialog();
    Dialog(const Dialog&) = delete;
    Dialog& operator=(const Dialog&) = delete;

    explicit operator bool() const { return drawn_; }

 private:
    bool& open_;
    bool drawn_ = false;
};

}  // namespace dapple
