// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ogive/core/error.hpp"
#include "ogive/io/atomic_file.hpp"
#include "ogive/io/text.hpp"
#include "ogive/sim/hash.hpp"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

/// \file
/// The format of a checkpoint, without a model: a header, the program's notes with a checksum, the state with a
/// checksum over everything.

namespace ogive {

/// A checkpoint in memory.
struct Checkpoint {
  std::string file;               ///< its name, for errors
  std::uint32_t scalar_bytes = 0; ///< size of the model's numbers
  std::string notes;              ///< the program's own
  std::string state;              ///< of model and run, for restore()
};

/// Throws SetupError "checkpoint = <file>: <reason>".
[[noreturn]] inline void refuse_checkpoint(const std::string &file, const std::string &reason) {
  throw SetupError("checkpoint = " + printable(file) + ": " + reason);
}

namespace checkpoint_detail {

/// The first byte is no text, and line ends show whether a file was copied as text.
inline constexpr std::array<char, 8> magic{'\x8f', 'o', 'g', 'i', 'v', 'e', '\r', '\n'};
inline constexpr std::uint32_t byte_order_mark = 0x01020304;

/// Grows by one when a reader of the present format would misread the new one. Fields that come or go need no new
/// version: the fingerprint of the model counts them.
inline constexpr std::uint32_t format_version = 1;

/// Header of a checkpoint file.
struct Header {
  std::array<char, 8> magic = checkpoint_detail::magic;
  std::uint32_t byte_order = byte_order_mark;
  std::uint32_t version = format_version;
  std::uint32_t scalar_bytes = 0;
  std::uint32_t reserved = 0;
  std::uint64_t notes_size = 0;
  std::uint64_t state_size = 0;
};
static_assert(sizeof(Header) == 40, "no padding, which would have any value");

/// A hash over bytes that come in pieces: the same however they are cut.
struct Checksum {
  std::uint64_t hash = hash_start;
  std::array<char, 8> held{};
  std::size_t count = 0; ///< of the bytes that are held

  void add(std::string_view bytes) {
    while (count > 0 && !bytes.empty()) {
      held[count++] = bytes[0];
      bytes.remove_prefix(1);
      if (count == held.size()) hash = hash_bytes(hash, {held.data(), held.size()}), count = 0;
    }
    const std::size_t whole = bytes.size() / held.size() * held.size();
    hash = hash_bytes(hash, bytes.substr(0, whole));
    for (const char byte : bytes.substr(whole)) held[count++] = byte;
  }
  std::uint64_t value() const { return hash_bytes(hash, {held.data(), count}); }
};

template <class V> std::string_view bytes_of_value(const V &value) {
  return {reinterpret_cast<const char *>(&value), sizeof value};
}

/// A file that is being read. Errors are SetupError.
struct Input {
  std::string name;
  std::unique_ptr<std::FILE, int (*)(std::FILE *)> file;
  std::uint64_t size = 0; ///< of the whole file
  Checksum sum{};

  /// Fills `to`; the file has been found long enough.
  void read(void *to, std::size_t bytes) {
    errno = 0;
    if (bytes > 0 && std::fread(to, 1, bytes, file.get()) != bytes)
      refuse_checkpoint(name, "cannot be read: " + (errno ? std::generic_category().message(errno) : "it has changed"));
    sum.add({static_cast<const char *>(to), bytes});
  }
  std::string read_text(std::uint64_t bytes) {
    std::string text(bytes, '\0');
    read(text.data(), bytes);
    return text;
  }
  void check_sum() {
    const std::uint64_t expected = sum.value();
    std::uint64_t found = 0;
    read(&found, sizeof found);
    if (found != expected) refuse_checkpoint(name, "is damaged: its checksum is wrong");
  }
};

inline Input open_input(const std::filesystem::path &path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    refuse_checkpoint(path.string(), "must be a regular file");
  Input input{path.string(), {std::fopen(path.c_str(), "rb"), &std::fclose}};
  if (!input.file)
    refuse_checkpoint(path.string(), "must be a file that can be read: " + std::generic_category().message(errno));
  input.size = std::filesystem::file_size(path, error);
  if (error) refuse_checkpoint(path.string(), "must be a file that can be read: " + error.message());
  return input;
}

/// Reads and checks the header. Sizes are compared with that of the file before anything is allocated.
inline Header read_header(Input &input) {
  Header header;
  const auto start = std::min<std::uint64_t>(input.size, sizeof header);
  input.read(&header, start);
  if (std::memcmp(&header, magic.data(), std::min<std::uint64_t>(start, magic.size())) != 0 || start == 0)
    refuse_checkpoint(input.name, "is not a checkpoint of ogive");
  const auto cut_short = [&](const std::string &whole) {
    refuse_checkpoint(input.name, "is cut short or damaged: it has " + std::to_string(input.size) + " bytes" + whole);
  };
  if (start < sizeof header) cut_short("");
  if (header.byte_order != byte_order_mark)
    refuse_checkpoint(input.name, "was written by a machine with another order of bytes");
  if (header.version != format_version)
    refuse_checkpoint(input.name, "has the format " + std::to_string(header.version) + ", this program reads format " +
                                      std::to_string(format_version));
  constexpr std::uint64_t around = sizeof(Header) + 2 * sizeof(std::uint64_t);
  if (header.notes_size > input.size || header.state_size > input.size ||
      around + header.notes_size + header.state_size != input.size)
    cut_short(", its header says otherwise");
  return header;
}

} // namespace checkpoint_detail

/// Writes a checkpoint file from the pieces of the state, atomically. Throws WriteError.
inline void write_checkpoint_file(const std::filesystem::path &path, std::uint32_t scalar_bytes, std::string_view notes,
                                  std::vector<std::string_view> state) {
  using namespace checkpoint_detail;
  Header header;
  header.scalar_bytes = scalar_bytes;
  header.notes_size = notes.size();
  for (const std::string_view piece : state) header.state_size += piece.size();
  Checksum sum;
  sum.add(bytes_of_value(header)), sum.add(notes);
  const std::uint64_t sum_of_notes = sum.value();
  sum.add(bytes_of_value(sum_of_notes));
  for (const std::string_view piece : state) sum.add(piece);
  const std::uint64_t sum_of_all = sum.value();
  state.insert(state.begin(), {bytes_of_value(header), notes, bytes_of_value(sum_of_notes)});
  state.push_back(bytes_of_value(sum_of_all));
  write_atomically(path, state);
}

/// Reads a checkpoint file. Whatever the file holds, no more is allocated than it has bytes. Throws SetupError, one
/// line, for a file that cannot be read, is not a checkpoint, is cut short, damaged or of another format.
inline Checkpoint read_checkpoint(const std::filesystem::path &path) {
  using namespace checkpoint_detail;
  Input input = open_input(path);
  const Header header = read_header(input);
  Checkpoint checkpoint{input.name, header.scalar_bytes, input.read_text(header.notes_size), {}};
  input.check_sum();
  checkpoint.state = input.read_text(header.state_size);
  input.check_sum();
  return checkpoint;
}

/// Reads only the notes of a checkpoint file. Throws SetupError as read_checkpoint() does; the state is not checked.
inline std::string read_checkpoint_notes(const std::filesystem::path &path) {
  using namespace checkpoint_detail;
  Input input = open_input(path);
  const Header header = read_header(input);
  std::string notes = input.read_text(header.notes_size);
  input.check_sum();
  return notes;
}

} // namespace ogive
