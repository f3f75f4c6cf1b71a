#include "lab/mpi/islands.h"

#include <algorithm>
#include <exception>
#include <vector>

#include "io/files/atomic_file.h"
#include "lab/commands/tile_annealing.h"
#include "lab/mpi/messages.h"

namespace dapple {
namespace {

Island best_of_ranks(const Island& mine) {
    const double energy = mine.energy;
    std::vector<double> energies(static_cast<std::size_t>(ranks_in_all()));
    MPI_Allgather(&energy, 1, MPI_DOUBLE, energies.data(), 1, MPI_DOUBLE, MPI_COMM_WORLD);
    const int stops = mine.stops;
    int any_stops = 0;
    MPI_Allreduce(&stops, &any_stops, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    Island best = mine;
    // All islands have as many points.
    const auto winner = static_cast<int>(std::ranges::min_element(energies) - energies.begin());
    MPI_Bcast(&best.energy, 1, MPI_DOUBLE, winner, MPI_COMM_WORLD);
    MPI_Bcast(best.letters.data(), static_cast<int>(best.letters.size()), MPI_CHAR, winner, MPI_COMM_WORLD);
    MPI_Bcast(best.successors.data(), static_cast<int>(best.successors.size()), MPI_UINT32_T, winner,
              MPI_COMM_WORLD);
    best.stops = any_stops != 0;
    return best;
}

}  // namespace

void search_kinds_on_ranks(const TileSearchOptions& options, std::ostream& out) {
    std::exception_ptr problem;
    if (rank_of_this() == 0) {
        try {
            check_can_save(*options.output);
        } catch (...) {
            problem = std::current_exception();
        }
    }
    int can_save = !problem;
    MPI_Bcast(&can_save, 1, MPI_INT, 0, MPI_COMM_WORLD);
    if (problem) std::rethrow_exception(problem);
    if (can_save == 0) return;
    IslandSearch side_by_side{.island = rank_of_this(), .islands = ranks_in_all()};
    if (side_by_side.islands > 1) side_by_side.best = best_of_ranks;
    search_kinds(options, out, side_by_side);
}

}  // namespace dapple
