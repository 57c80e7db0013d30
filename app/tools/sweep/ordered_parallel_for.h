// Work that is done piece by piece on several threads and handed over in order on one: as if one thread had done it
// all, only sooner. Holds a few pieces per thread at most, however slow the taker is.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace ghostforce {

template <typename Piece>
class OrderedParallelFor {
 public:
  // Calls make(i) for i = 0 … count−1 on `thread_count` threads, and take(piece) for each in order on this one, until
  // take() returns false. What make() or take() throws comes out here, once no thread runs any more.
  static void run(std::int64_t count, std::size_t thread_count, const std::function<Piece(std::int64_t)>& make,
                  const std::function<bool(Piece&&)>& take) {
    OrderedParallelFor work(count, thread_count, make);
    for (std::int64_t i = 0; i < count; ++i) {
      if (!take(work.wait_for(i))) return;
    }
  }

 private:
  // Enough that no thread waits while one of them has a slow piece.
  static constexpr std::size_t pieces_per_thread = 4;

  OrderedParallelFor(std::int64_t count, std::size_t thread_count, const std::function<Piece(std::int64_t)>& make)
      : count_(count), make_(make), ready_(pieces_per_thread * thread_count) {
    threads_.reserve(thread_count);
    for (std::size_t i = 0; i < thread_count; ++i) {
      try {
        threads_.emplace_back([this] { make_pieces(); });
      } catch (const std::system_error&) {
        if (threads_.empty()) throw;
        break;  // as many as this process may have
      }
    }
  }
  ~OrderedParallelFor() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    room_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }
  OrderedParallelFor(const OrderedParallelFor&) = delete;
  OrderedParallelFor& operator=(const OrderedParallelFor&) = delete;

  std::optional<Piece>& slot(std::int64_t piece) { return ready_[static_cast<std::size_t>(piece) % ready_.size()]; }

  void make_pieces() {
    for (;;) {
      std::unique_lock lock(mutex_);
      room_.wait(lock, [this] {
        return is_over_ || next_ == count_ || next_ < taken_ + static_cast<std::int64_t>(ready_.size());
      });
      if (is_over_ || next_ == count_) return;
      const std::int64_t i = next_++;
      lock.unlock();
      std::optional<Piece> piece;
      std::exception_ptr error;
      try {
        piece.emplace(make_(i));
      } catch (...) {
        error = std::current_exception();
      }
      lock.lock();
      slot(i) = std::move(piece);
      if (error) error_ = error;
      is_ready_.notify_one();
    }
  }

  Piece wait_for(std::int64_t i) {
    std::unique_lock lock(mutex_);
    is_ready_.wait(lock, [this, i] { return error_ || slot(i); });
    if (error_) std::rethrow_exception(error_);
    Piece piece = std::move(*slot(i));
    slot(i).reset();
    taken_ = i + 1;
    room_.notify_all();
    return piece;
  }

  const std::int64_t count_;
  const std::function<Piece(std::int64_t)>& make_;
  std::mutex mutex_;  // guards all that follows, save the threads
  std::condition_variable room_;
  std::condition_variable is_ready_;
  std::vector<std::optional<Piece>> ready_;  // made and not taken, piece i at i modulo the size
  std::int64_t next_ = 0;                    // to be made
  std::int64_t taken_ = 0;
  bool is_over_ = false;
  std::exception_ptr error_;
  std::vector<std::thread> threads_;
};

}  // namespace ghostforce
