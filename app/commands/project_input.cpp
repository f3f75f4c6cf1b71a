#include "app/commands/project_input.h"

#include <stdexcept>
#include <utility>

#include "core/settings/drawing_fields.h"
#include "core/text/shown_text.h"
#include "io/settings/project.h"

namespace dapple {

ProjectInput read_project_input(const std::filesystem::path& file) {
    ProjectInput input;
    bool photograph = true;
    Project project = read_project(file, [&](Fields& fields) {
        describe_drawing(fields, input.drawing, input.saving);
        fields.group("density", [&](Fields& density) {
            density.choice(
                "source", photograph,
                {NamedValue{"photograph", true}, NamedValue{"grey", false}, NamedValue{"ramp", false}});
        });
    });
    if (!project.why_missing.empty()) throw std::runtime_error(project.why_missing);
    input.picture = std::move(project.picture);
    if (!photograph)
        throw std::runtime_error(
            printable(file.native()) +
            ": shows a plain density, which the window alone draws; choose the photograph "
            "there, under The method, and save it again");
    return input;
}

}  // namespace dapple
