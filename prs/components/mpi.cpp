// Omits the C++ bindings that MPI has dropped.
#define OMPI_SKIP_MPICXX
#include <mpi.h>
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "prs/components/components.h"

namespace prs {
namespace {

class MpiCommunicator : public Communicator {
 public:
  MpiCommunicator() {
    int level = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  ~MpiCommunicator() override {
    // MPI_Finalize would wait for the first rank, which now writes files, and keep a processor busy.
    MPI_Request barrier = MPI_REQUEST_NULL;
    MPI_Ibarrier(MPI_COMM_WORLD, &barrier);
    for (int done = 0; done == 0; std::this_thread::sleep_for(std::chrono::microseconds(100)))
      MPI_Test(&barrier, &done, MPI_STATUS_IGNORE);
    MPI_Finalize();
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  int processors_each() override {
    cpu_set_t own;
    CPU_ZERO(&own);
    sched_getaffinity(0, sizeof own, &own);
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    int ranks = 1;
    MPI_Comm_size(machine, &ranks);
    cpu_set_t all;
    CPU_ZERO(&all);
    MPI_Allreduce(&own, &all, sizeof own, MPI_BYTE, MPI_BOR, machine);
    MPI_Comm_free(&machine);
    return std::max(1, CPU_COUNT(&all) / ranks);
  }

  void send(int rank, int tag, std::string_view content) override {
    MPI_Send(content.data(), static_cast<int>(content.size()), MPI_CHAR, rank, tag, MPI_COMM_WORLD);
  }
  std::optional<Message> receive() override {
    int there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (there == 0) return std::nullopt;
    int length = 0;
    MPI_Get_count(&status, MPI_CHAR, &length);
    Message message{status.MPI_SOURCE, status.MPI_TAG, std::string(static_cast<std::size_t>(length), '\0')};
    MPI_Recv(message.content.data(), length, MPI_CHAR, message.rank, message.tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
  }

  void broadcast(std::optional<std::string>& text) override {
    int length = text ? static_cast<int>(text->size()) : -1;
    MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
    if (length < 0) return text.reset();
    if (rank_ > 0) text.emplace(static_cast<std::size_t>(length), '\0');
    MPI_Bcast(text->data(), length, MPI_CHAR, 0, MPI_COMM_WORLD);
  }
  bool all(bool own) override {
    int same = own ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &same, 1, MPI_INT, MPI_LAND, MPI_COMM_WORLD);
    return same != 0;
  }
  void abort() override { MPI_Abort(MPI_COMM_WORLD, 1); }

 private:
  int rank_ = 0;
  int size_ = 1;
};

}  // namespace
}  // namespace prs

extern "C" __attribute__((visibility("default"))) const prs::MpiModule prs_module{
    {}, []() -> std::unique_ptr<prs::Communicator> { return std::make_unique<prs::MpiCommunicator>(); }};
