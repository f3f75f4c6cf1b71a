#pragma once
// What shuts a decoder in: code that a hostile file brought into it finds no files, no network, no other
// process, and nobody to live on with. All of it on Linux only; elsewhere nothing happens here.
//
// A program that this is linked into can open only the file that is its descriptor kPictureFile, and what
// libraries look up of the system: time zones, processors, libraries; and those only to read, where the
// kernel has Landlock; where it has none, root's may not read other people's files. That begins before
// main(), because some libraries start threads while they are loaded, and Landlock binds none that is there
// already.

#include <stdexcept>

namespace dapple {

/// The system refuses: a sentence.
struct NoSandbox : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Where a decoder finds the picture.
inline constexpr int kPictureFile = 3;

/// From now on the process ends when the thread that started it does, or at once if that has ended already
/// and with it the pipe's other end.
void end_with_parent(int pipe);

/// From now on, in all threads, a system call that no picture needs ends the process by SIGSYS, files can be
/// opened only to read, nobody else may look at its memory, and its limits can only be lowered, by root too.
///
/// To be called once the libraries are loaded and limit_decoder() was, before anything of the picture is
/// read. Throws NoSandbox.
void enter_sandbox();

}  // namespace dapple
