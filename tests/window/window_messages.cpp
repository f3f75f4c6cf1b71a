#include "tests/window/window_messages.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <chrono>
#include <cstring>
#include <functional>
#include <thread>
#include <vector>

namespace dapple {
namespace {

/// A connection to the display of the environment.
class Connection {
 public:
    Connection() : display_(XOpenDisplay(nullptr)) {
        // Windows may be gone when something is sent to them.
        XSetErrorHandler([](::Display*, XErrorEvent*) { return 0; });
    }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    ~Connection() {
        if (display_) XCloseDisplay(display_);
    }

    ::Display* get() const { return display_; }
    Window root() const { return DefaultRootWindow(display_); }
    Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

    /// None if there is none.
    Window window(const std::string& end_of_title) const {
        Window parent = 0, top = 0, *children = nullptr, found = 0;
        unsigned count = 0;
        if (!display_ || !XQueryTree(display_, root(), &top, &parent, &children, &count)) return 0;
        for (unsigned i = 0; i < count; ++i) {
            char* name = nullptr;
            if (!XFetchName(display_, children[i], &name) || !name) continue;
            if (std::string_view(name).ends_with(end_of_title)) found = children[i];
            XFree(name);
        }
        if (children) XFree(children);
        return found;
    }

    void tell(Window window, const char* type, std::vector<long> numbers) const {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = window;
        event.xclient.message_type = atom(type);
        event.xclient.format = 32;
        numbers.resize(5);
        for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = numbers[static_cast<std::size_t>(i)];
        XSendEvent(display_, window, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// Gives each event to `take` until it says that this was it, or some seconds have passed.
    void listen(const std::function<bool(const XEvent&)>& take) const {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(3);
        while (std::chrono::steady_clock::now() < end) {
            while (XPending(display_) > 0) {
                XEvent event;
                XNextEvent(display_, &event);
                if (take(event)) return;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }

 private:
    ::Display* display_;
};

// What is dropped, for the window that asks for it.
void hand_over(const Connection& x, const XSelectionRequestEvent& request, const std::string& uris) {
    XChangeProperty(x.get(), request.requestor, request.property, request.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(uris.data()), static_cast<int>(uris.size()));
    XEvent answer{};
    answer.xselection.type = SelectionNotify;
    answer.xselection.requestor = request.requestor;
    answer.xselection.selection = request.selection;
    answer.xselection.target = request.target;
    answer.xselection.property = request.property;
    answer.xselection.time = request.time;
    XSendEvent(x.get(), request.requestor, False, NoEventMask, &answer);
    XFlush(x.get());
}

}  // namespace

void ask_to_close(const std::string& end_of_title) {
    const Connection x;
    const Window window = x.window(end_of_title);
    if (!window) return;
    x.tell(window, "WM_PROTOCOLS", {static_cast<long>(x.atom("WM_DELETE_WINDOW")), CurrentTime});
}

void drop_file(const std::string& end_of_title, const std::filesystem::path& file, int px, int py) {
    const Connection x;
    const Window window = x.window(end_of_title);
    if (!window) return;
    const std::string uris = "file://" + file.string() + "\r\n";
    const Window source = XCreateSimpleWindow(x.get(), x.root(), 0, 0, 1, 1, 0, 0, 0);
    const auto from = static_cast<long>(source);
    XSetSelectionOwner(x.get(), x.atom("XdndSelection"), source, CurrentTime);
    constexpr long kVersion = 5;
    x.tell(window, "XdndEnter", {from, kVersion << 24, static_cast<long>(x.atom("text/uri-list"))});
    x.tell(window, "XdndPosition",
           {from, 0, static_cast<long>(px) << 16 | py, CurrentTime,
            static_cast<long>(x.atom("XdndActionCopy"))});
    const auto is = [&](const XEvent& event, const char* type) {
        return event.type == ClientMessage && event.xclient.message_type == x.atom(type);
    };
    x.listen([&](const XEvent& event) { return is(event, "XdndStatus"); });
    x.tell(window, "XdndDrop", {from, 0, CurrentTime});
    x.listen([&](const XEvent& event) {
        if (event.type == SelectionRequest) hand_over(x, event.xselectionrequest, uris);
        return is(event, "XdndFinished");
    });
    XDestroyWindow(x.get(), source);
}

}  // namespace dapple
