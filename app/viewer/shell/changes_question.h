#pragma once
// What is asked where changes would be lost.

#include <cstddef>
#include <string>

namespace dapple {

enum class ChangesAnswer { none, save, discard, next, cancel };

/// Asks what to do with the changes to what has that name, until there is an answer. Return saves, D
/// discards, Escape cancels.
ChangesAnswer ask_about_changes(const std::string& name);

/// Asks whether the window goes once the file of that name is saved (`save`), or without it.
ChangesAnswer ask_about_saving(const std::string& name);

/// Asks what to do with a drawing that was not saved when the program ended; `save` is to bring it back.
/// Cancel leaves it for the next time. Where there are `others`, `next` is to ask about one of those.
ChangesAnswer ask_about_kept(const std::string& name, std::size_t others);

}  // namespace dapple
