#include "io/command_line/program.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

namespace dapple {
namespace {

// roff takes a backslash, a hyphen, and a point or quote that begins a line for something else.
std::string roff(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\\')
            result += "\\e";
        else if (c == '-')
            result += "\\-";
        else if ((c == '.' || c == '\'') && result.empty())
            result += std::string("\\&") + c;
        else
            result += c;
    }
    return result;
}

std::string bold(std::string_view text) {
    return "\\fB" + roff(text) + "\\fR";
}

std::string italic(std::string_view text) {
    return "\\fI" + roff(text) + "\\fR";
}

// "DAPPLE", as titles have it.
std::string in_capitals(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c; });
    return text;
}

bool takes_value(const CLI::Option& option) {
    return option.get_items_expected_max() > 0;
}

// "dapple tile show"
std::string full_name(const CLI::App& command) {
    const CLI::App* const parent = command.get_parent();
    return parent ? full_name(*parent) + " " + command.get_name() : command.get_name();
}

// "-o, --output OUT"
std::string names_of(const CLI::Option& option) {
    std::string names;
    for (const std::string& name : option.get_snames())
        names += (names.empty() ? "" : ", ") + bold("-" + name);
    for (const std::string& name : option.get_lnames())
        names += (names.empty() ? "" : ", ") + bold("--" + name);
    if (names.empty() || takes_value(option))
        names += (names.empty() ? "" : " ") + italic(option.get_type_name());
    return names;
}

void write_usage(std::ostream& out, const CLI::App& command) {
    out << bold(full_name(command));
    if (!command.get_subcommands({}).empty() && command.get_parent()) {
        out << ' ' << italic("COMMAND") << '\n';
        return;
    }
    out << " [" << italic("OPTIONS") << "]";
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_positional() && option->get_required())
            out << ' ' << bold("--" + option->get_lnames().front()) << ' ' << italic(option->get_type_name());
    }
    for (const CLI::Option* option : command.get_options()) {
        if (!option->get_positional()) continue;
        const std::string name = italic(option->get_type_name());
        out << ' ' << (option->get_required() ? name : "[" + name + "]");
    }
    out << '\n';
}

// Indented lines as they are; the others run on.
void write_footer(std::ostream& out, const std::string& text) {
    bool as_is = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const bool indented = line.starts_with(' ');
        if (indented != as_is) out << (indented ? ".PP\n.nf\n" : ".fi\n");
        as_is = indented;
        out << (line.empty() ? ".PP" : roff(line)) << '\n';
    }
    if (as_is) out << ".fi\n";
}

void write_options(std::ostream& out, const CLI::App& command) {
    const bool is_program = command.get_parent() == nullptr;
    for (const std::string& group : command.get_groups()) {
        if (group.empty()) continue;
        if (group != "Options") out << ".PP\n" << bold(group) << '\n';
        for (const CLI::Option* option : command.get_options()) {
            // Every command has --help: once is enough.
            if (option->get_group() != group || (!is_program && option == command.get_help_ptr())) continue;
            out << ".TP\n" << names_of(*option) << '\n' << roff(option->get_description());
            if (!option->get_default_str().empty()) out << " (" << roff(option->get_default_str()) << ')';
            out << '\n';
        }
    }
}

void write_commands(std::ostream& out, const CLI::App& parent) {
    for (const CLI::App* command : parent.get_subcommands({})) {
        if (command->get_group().empty()) continue;
        out << ".SS " << roff(full_name(*command)) << '\n';
        write_usage(out, *command);
        out << ".PP\n" << roff(command->get_description()) << ".\n";
        write_options(out, *command);
        out << ".PP\n";
        write_footer(out, command->get_footer());
        write_commands(out, *command);
    }
}

// Every command with every option, but for those that help does not show.
void write_manual(std::ostream& out, const CLI::App& program) {
    out << ".TH " << in_capitals(program.get_name()) << " 1 \"\" \"" << roff(program.version())
        << "\" \"User Commands\"\n";
    out << ".SH NAME\n" << roff(program.get_name()) << " \\- " << roff(program.get_description()) << '\n';
    out << ".SH SYNOPSIS\n";
    write_usage(out, program);
    out << ".br\n" << bold(program.get_name()) << ' ' << italic("COMMAND") << " ...\n";
    out << ".SH DESCRIPTION\n";
    write_footer(out, program.get_footer());
    out << ".SH OPTIONS\n";
    write_options(out, program);
    out << ".SH COMMANDS\n";
    write_commands(out, program);
    out << ".SH EXIT STATUS\n"
           ".TP\n0\nAll was done.\n"
           ".TP\n1\nSomething could not be done, and a sentence on the standard error says what.\n"
           ".TP\n2\nThe command line is wrong: nothing was begun.\n";
}

}  // namespace

void add_manual_command(CLI::App& program) {
    program.add_subcommand("manual", "The manual page, for man")->group("")->callback([&program] {
        write_manual(std::cout, program);
    });
}

}  // namespace dapple
