#pragma once
// Texts from rank to rank, by MPI. Who waits sleeps, where MPI's own waiting would keep a core busy.

#include <mpi.h>

#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace dapple {

inline int rank_of_this() {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    return rank;
}

inline int ranks_in_all() {
    int ranks = 1;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    return ranks;
}

inline void send_text(int to, const std::string& text) {
    MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, 0, MPI_COMM_WORLD);
}

struct Message {
    int from = 0;
    std::string text;
};

/// The next message that has come; nothing if none has.
inline std::optional<Message> message_there() {
    int there = 0, size = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &there, &status);
    if (there == 0) return std::nullopt;
    MPI_Get_count(&status, MPI_CHAR, &size);
    Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Recv(message.text.data(), size, MPI_CHAR, message.from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
}

inline void wait_a_moment() {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
}

inline Message next_message() {
    while (true) {
        if (auto message = message_there()) return *std::move(message);
        wait_a_moment();
    }
}

}  // namespace dapple
