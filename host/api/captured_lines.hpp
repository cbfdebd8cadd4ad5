// The lines of captured files, written and read by one description: describe(Fields&, object) is called with either.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace quell {

/// A number of 16 hexadecimal digits.
struct Hash {
  std::uint64_t value = 0;
};
std::string hashText(std::uint64_t hash);

/// Makes lines: a word, then values.
class LineWriter {
 public:
  static constexpr bool kReads = false;

  template <class... Values>
  void line(const char* word, const Values&... values) {
    m_text += word;
    (put(values), ...);
    m_text += '\n';
  }
  /// A line that there may be.
  template <class... Values>
  void lineIf(bool present, const char* word, const Values&... values) {
    if (present) line(word, values...);
  }
  /// A text with blanks, to the end of its line.
  void text(const char* word, const std::string& value) { m_text += std::string(word) + " " + value + "\n"; }
  /// Lines that repeat are counted first.
  template <class Items>
  void count(const char* word, const Items& items) {
    line(word, static_cast<std::uint64_t>(items.size()));
  }
  /// All lines, and one more with their checksum.
  std::string finish() const;

 private:
  void putWord(const std::string& word) { m_text += " " + word; }
  void put(double value);
  void put(Hash hash) { putWord(hashText(hash.value)); }
  void put(const std::string& word) { putWord(word); }
  template <class Value, std::enable_if_t<std::is_integral_v<Value>, int> = 0>
  void put(Value value) {
    putWord(std::to_string(value));
  }
  template <class Value, std::enable_if_t<std::is_enum_v<Value>, int> = 0>
  void put(Value value) {
    putWord(std::to_string(static_cast<int>(value)));
  }
  template <class Value, std::size_t count>
  void put(const std::array<Value, count>& values) {
    for (const Value& value : values) put(value);
  }

  std::string m_text;
};

/// Takes such lines apart in the same order. Everything throws Error(FileError) for what is not as written.
class LineReader {
 public:
  static constexpr bool kReads = true;

  /// Looks for the last line and compares the checksum.
  LineReader(std::string path, const std::vector<unsigned char>& bytes);

  template <class... Values>
  void line(const char* word, Values&... values) {
    begin(word);
    (get(values), ...);
    end();
  }
  template <class... Values>
  void lineIf(bool, const char* word, Values&... values) {
    if (nextIs(word)) line(word, values...);
  }
  void text(const char* word, std::string& value);
  template <class Items>
  void count(const char* word, Items& items) {
    std::uint64_t number = 0;
    line(word, number);
    if (number > m_lines)
      refuse(std::string("as many ") + word + " as there are lines", std::to_string(number));
    items.resize(static_cast<std::size_t>(number));
  }
  /// A block of bytes that lies behind the lines, in their order; readContents() fills it.
  void expectContent(std::vector<unsigned char>& content, std::uint64_t bytes, Hash hash) {
    m_blocks.push_back({&content, bytes, hash});
  }
  /// Of the whole file.
  void readContents(const std::vector<unsigned char>& bytes) const;
  [[noreturn]] void refuse(const std::string& expected, const std::string& got) const;

 private:
  bool nextIs(const std::string& word) const;
  void begin(const char* word);
  void end() const;
  std::string word();
  std::int64_t whole(std::int64_t least, std::int64_t most);
  void get(double& value);
  void get(std::string& value) { value = word(); }
  void get(Hash& hash);
  void get(std::uint64_t& value);
  void get(bool& value) { value = whole(0, 1) != 0; }
  template <class Value, std::enable_if_t<std::is_integral_v<Value>, int> = 0>
  void get(Value& value) {
    constexpr std::int64_t most =
        sizeof(Value) < 8
            ? (std::int64_t{1} << (8 * sizeof(Value) - 1)) * (std::is_signed_v<Value> ? 1 : 2) - 1
            : INT64_MAX;
    value = static_cast<Value>(whole(std::is_signed_v<Value> ? -most : 0, most));
  }
  /// What an enumerator means is checked by those who use it.
  template <class Value, std::enable_if_t<std::is_enum_v<Value>, int> = 0>
  void get(Value& value) {
    value = static_cast<Value>(whole(0, 127));
  }
  template <class Value, std::size_t count>
  void get(std::array<Value, count>& values) {
    for (Value& value : values) get(value);
  }

  struct Block {
    std::vector<unsigned char>* content;
    std::uint64_t bytes;
    Hash hash;
  };
  std::vector<Block> m_blocks;
  std::string m_path;
  std::string m_text;  // without the last line
  std::size_t m_size = 0;
  std::size_t m_lines = 0;
  std::size_t m_next = 0;  // where the next line begins
  std::string m_line;      // the rest of this one
};

}  // namespace quell
