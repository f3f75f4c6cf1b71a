#pragma once
// An entry of a list, with a small picture at its left or without one.

#include <imgui.h>

#include <string>

namespace dapple {

struct EntryPicture {
    ImTextureID texture{};  // none: not there (yet)
    ImVec2 size{0, 0};      // of the picture, pixels: its shape counts
    bool awaited = false;   // it is still to be made: its place is shown meanwhile, and stays bare otherwise
};

/// The box that pictures of entries are fitted into, in heights of a line of text.
struct EntryBox {
    float width = 4.2f, height = 2.8f;
};

/// As ImGui::Selectable(), of a label that people choose, such as a file's name: ## in it is nothing but two
/// characters.
bool text_entry(const std::string& label, bool chosen, ImGuiSelectableFlags flags = 0);

/// As ImGui::Selectable(), so high as its box. Grey words may stand below its label.
bool picture_entry(const std::string& label, const std::string& words, bool chosen,
                   const EntryPicture& picture, const EntryBox& box = {}, ImGuiSelectableFlags flags = 0);

/// An entry of a strip: the picture with its name below, as wide as its box. `note`: as note_place() has it.
bool strip_entry(const std::string& note, const std::string& name, bool chosen, const EntryPicture& picture,
                 const EntryBox& box);
/// How high a strip of them is, with its scroll bar.
float strip_height(const EntryBox& box);

/// Whether the next entry will be on screen: only then is its picture worth the work.
bool next_entry_shows(const EntryBox& box = {});

}  // namespace dapple
