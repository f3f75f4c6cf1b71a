#pragma once
// Undo for anything that is one value.

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/model/viewer_settings.h"

namespace dapple {

// What was changed, in a word or two: what a button offers to undo.

/// The names of the rows that say it: "Contrast", "Dot size and 2 more"; empty if they are equal in all that
/// is saved.
std::string change_in_words(const ViewerSettings& before, const ViewerSettings& after);

template <class Value>
class History {
 public:
    explicit History(Value first) : kept_{std::move(first)} {}

    /// To be told the value each frame. Keeps it once the person has let go of what they were editing, so
    /// that a slider's drag is one step.
    void observe(const Value& now, bool editing) {
        if (editing || now == kept_[at_]) return;
        kept_.resize(at_ + 1);
        kept_.push_back(now);
        if (kept_.size() > kMostSteps) kept_.erase(kept_.begin());
        at_ = kept_.size() - 1;
        ++changes_;
    }

    /// What undo() and redo() would come to; null at either end.
    const Value* before() const { return can_undo() ? &kept_[at_ - 1] : nullptr; }
    const Value* after() const { return can_redo() ? &kept_[at_ + 1] : nullptr; }
    const Value& now() const { return kept_[at_]; }
    /// A number that changes with all of these.
    int changes() const { return changes_; }

    bool can_undo() const { return at_ > 0; }
    bool can_redo() const { return at_ + 1 < kept_.size(); }

    /// The value one step back or forward; the present one at either end.
    const Value& undo() { return go(can_undo() ? -1 : 0); }
    const Value& redo() { return go(can_redo() ? 1 : 0); }

 private:
    const Value& go(int steps) {
        ++changes_;
        return kept_[at_ += static_cast<std::size_t>(steps)];
    }

    static constexpr std::size_t kMostSteps = 500;
    std::vector<Value> kept_;
    std::size_t at_ = 0;
    int changes_ = 0;
};

}  // namespace dapple
