// The page reads what PNG files say of themselves; it decodes none.
#include "app/files/png_file.h"

#include <string_view>

#include "app/base/quoted.h"
#include "app/files/deflate.h"
#include "app/files/input_file.h"
#include "app/files/read_error.h"

namespace ghostforce {

struct PngFile::Reading {
  std::string path;
  int width = 0;
  int height = 0;
  std::vector<PngText> texts;

  void require(bool is_good, std::string_view why) const {
    if (is_good) return;
    throw ReadError(ReadError::Kind::unreadable, {{.file = quoted_text(path, longest_path),
                                                   .what = "cannot be read as a PNG picture: " + std::string(why)}});
  }
};

namespace {

std::uint32_t number_at(std::string_view bytes, std::size_t place) {
  std::uint32_t number = 0;
  for (const char byte : bytes.substr(place, 4)) number = number << 8U | static_cast<unsigned char>(byte);
  return number;
}

// A keyword, a zero, and then the text: at once (tEXt), or after four more fields (iTXt). Empty keyword: it is none, or
// compressed.
PngText text_in(std::string_view name, std::string_view data) {
  const std::size_t keyword_end = data.find('\0');
  if (keyword_end == std::string_view::npos) return {};
  const std::string keyword(data.substr(0, keyword_end));
  std::string_view rest = data.substr(keyword_end + 1);
  if (name == "tEXt") return {keyword, std::string(rest)};
  if (name != "iTXt" || rest.size() < 2 || rest.front() != '\0') return {};
  rest.remove_prefix(2);
  for (int field = 0; field < 2; ++field) {  // the language, and the keyword in it
    const std::size_t end = rest.find('\0');
    if (end == std::string_view::npos) return {};
    rest.remove_prefix(end + 1);
  }
  return {keyword, std::string(rest)};
}

}  // namespace

PngFile::PngFile(const std::string& path, PngWords words) : reading_(std::make_unique<Reading>()) {
  Reading& reading = *reading_;
  reading.path = path;
  const FileContents file = file_contents(path);
  reading.require(file.error == 0, file.error != 0 ? unreadable_words(file.error) : "");
  std::string_view bytes = file.text;
  reading.require(bytes.starts_with(png_signature), "it is another kind of file");
  bytes.remove_prefix(png_signature.size());
  constexpr std::size_t frame = 12;  // length, name and checksum of a chunk
  for (bool is_first = true;; is_first = false) {
    reading.require(bytes.size() >= frame && number_at(bytes, 0) <= bytes.size() - frame, "the file ends too early");
    const std::size_t length = number_at(bytes, 0);
    const std::string_view name = bytes.substr(4, 4);
    const std::string_view data = bytes.substr(8, length);
    reading.require(checksum(bytes.substr(4, 4 + length)) == number_at(bytes, 8 + length), "it is damaged");
    if (is_first) {
      reading.require(name == "IHDR" && length >= 8, "its header is missing");
      reading.width = static_cast<int>(number_at(data, 0));
      reading.height = static_cast<int>(number_at(data, 4));
    } else if (name == "IDAT" || name == "IEND") {
      return;
    } else if (words == PngWords::read) {
      if (PngText text = text_in(name, data); !text.keyword.empty()) reading.texts.push_back(std::move(text));
    }
    bytes.remove_prefix(frame + length);
  }
}

PngFile::~PngFile() = default;

int PngFile::width() const noexcept {
  return reading_->width;
}

int PngFile::height() const noexcept {
  return reading_->height;
}

std::vector<PngText> PngFile::texts() const {
  return reading_->texts;
}

}  // namespace ghostforce
