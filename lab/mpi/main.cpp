// dapple-mpi: what outgrows one machine, shared among the ranks of an MPI job.
//
//      mpirun dapple-mpi tile search --points 32        parts of an exhaustive search
//      mpirun dapple-mpi tile search --kinds 16 ...     islands that anneal and exchange their best
//
// Murals and batches need no MPI: `dapple render --share auto` reads which rank it is.

#include <mpi.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "core/text/shown_text.h"
#include "io/command_line/program.h"
#include "lab/commands/tile_enumeration.h"
#include "lab/commands/tile_search.h"
#include "lab/mpi/islands.h"
#include "lab/mpi/messages.h"
#include "lab/mpi/shared_search.h"

namespace {

using namespace dapple;

constexpr int kFailed = 1, kUsage = 2;

int report(const std::string& sentence, int code) {
    std::fprintf(stderr, "dapple-mpi: %s\n", shortened(printable(sentence)).c_str());
    return code;
}

int run(CLI::App& program, const std::vector<std::string>& words, const bool& parsed) {
    try {
        program.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        return 0;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return rank_of_this() == 0 ? program.exit(error) : 0;
        return rank_of_this() == 0 ? report(error.what(), kUsage) : kUsage;
    } catch (const std::exception& error) {
        return report(error.what(), parsed ? kFailed : kUsage);
    }
}

}  // namespace

int main(int argc, char** argv) {
    MPI_Init(&argc, &argv);
    CLI::App program{"Work that dapple-lab shares among the ranks of an MPI job.", "dapple-mpi"};
    program.formatter(wrapped_help());
    program.require_subcommand(1);
    program.footer(
        "Options are those of `dapple-lab tile search`. Murals and batches are shared without it: mpirun "
        "dapple\n"
        "render ... --share auto.\n\n"
        "Examples:\n"
        "  mpirun -n 8 dapple-mpi tile search --points 32\n"
        "  mpirun -n 8 dapple-mpi tile search --kinds 16 --points 1024 --seed 1 -o kinds.tile");
    bool parsed = false;
    program.parse_complete_callback([&] { parsed = true; });
    CLI::App* const tile = program.add_subcommand("tile", "Tiles: search");
    tile->require_subcommand(1);
    CLI::App* const search =
        tile->add_subcommand("search", "Look for the best tiles of the paper's kind, or of several kinds");
    TileSearchOptions options;
    add_search_options(*search, options);
    bool searches = false;
    search->callback([&] {
        check_search_options(*search, options);
        if (options.kinds > 1) return search_kinds_on_ranks(options, std::cout);
        if (!options.cycles.empty() || options.kind != SearchKind::identity ||
            options.by != TileCriterion::radius || options.estimate)
            throw CLI::ValidationError("tile search",
                                       "only searches for identity by radius and with --kinds are shared; "
                                       "use dapple-lab tile search");
        searches = true;
        if (rank_of_this() > 0) return search_for_rank_0();
        search_by_radius(options, std::cout, continue_on_ranks);
    });

    const std::vector<std::string> words(argv + 1, argv + argc);
    const int status = run(program, words, parsed);
    if (searches && rank_of_this() == 0) end_ranks();
    std::cout.flush();
    int worst = 0;
    MPI_Allreduce(&status, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    MPI_Finalize();
    return worst;
}
