#pragma once
// What is asked where changes would be lost.

#include <string>

namespace dapple {

enum class ChangesAnswer { none, save, discard, cancel };

/// Asks what to do with the changes to what has that name, until there is an answer. Return saves, D
/// discards, Escape cancels.
ChangesAnswer ask_about_changes(const std::string& name);

/// Asks what to do with a drawing that was not saved when the program ended; `save` is to bring it back.
/// Cancel leaves it for the next time.
ChangesAnswer ask_about_kept(const std::string& name);

}  // namespace dapple
