#pragma once
// A page that shows which sheet of a mural goes where, and tells how to cut and join them.

#include <ostream>
#include <string>

#include "core/output/sheet.h"
#include "core/placing/page.h"

namespace dapple {

struct AssemblyPlan {
    PageSize page;       // the whole mural
    Sheet sheets;        // how many there are, and their overlap
    std::string name;    // the files are name-A1 and so on,
    std::string ending;  // with this ending
};

/// An SVG of an upright A4 page: the mural to scale with its sheets' names, the shared strips grey and the
/// lines to cut along dashed, and the steps in words. The same plan is the same file.
void write_assembly_plan(std::ostream& out, const AssemblyPlan& plan);

}  // namespace dapple
