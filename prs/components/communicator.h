#pragma once

#include <memory>
#include <optional>
#include <string>

#include "modules/module.h"

namespace prs {

/// The processes that an MPI launcher started together, numbered from 0. Only one thread of each
/// uses it, but for `abort`. The end of the object waits for those of all others.
class Communicator {
 public:
  struct Message {
    int rank = 0;  ///< Rank of the sender.
    int tag = 0;
    std::string content;
  };

  Communicator() = default;
  virtual ~Communicator() = default;
  Communicator(const Communicator&) = delete;
  Communicator& operator=(const Communicator&) = delete;

  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// Processors that all processes of this machine may use, for each of these. At least 1.
  virtual int processors_each() = 0;

  virtual void send(int rank, int tag, std::string_view content) = 0;
  /// A message that has arrived and was not received yet. Does not wait.
  virtual std::optional<Message> receive() = 0;

  /// Every process must call these two. The first sends what rank 0 hands over, if anything, to
  /// all; the second tells whether a condition holds on all.
  virtual void broadcast(std::optional<std::string>& text) = 0;
  virtual bool all(bool own) = 0;

  /// Ends all processes.
  virtual void abort() = 0;
};

struct MpiModule : modules::Module {
  static constexpr modules::Name kName{"prs_mpi.so", "MPI", "libopenmpi-dev",
                                       ", or compute parts by --shard i/n"};
  std::unique_ptr<Communicator> (*join)();
};

}  // namespace prs
