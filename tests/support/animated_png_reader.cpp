#include "tests/support/animated_png_reader.h"

#include <zlib.h>

#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "tests/app/files/png_pieces.h"

namespace ghostforce {
namespace {

void require(bool is_good, const std::string& what) {
  if (!is_good) throw std::runtime_error(what);
}

class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  std::string_view take(std::size_t count) {
    require(count <= bytes_.size(), "the data end too early");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  std::uint32_t number(std::size_t count) {
    std::uint32_t value = 0;
    for (const char c : take(count)) value = value << 8U | static_cast<unsigned char>(c);
    return value;
  }
  std::string_view until_zero() {
    const std::size_t length = bytes_.find('\0');
    require(length != std::string_view::npos, "a text has no end");
    const std::string_view taken = take(length);
    take(1);
    return taken;
  }
  std::string_view rest() { return take(bytes_.size()); }
  bool is_empty() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

struct Chunk {
  std::string_view name;
  std::string_view data;
};

std::vector<Chunk> chunks_of(std::string_view file) {
  Bytes bytes(file);
  require(bytes.take(8) == std::string_view("\x89PNG\r\n\x1A\n"), "no PNG signature");
  std::vector<Chunk> chunks;
  while (!bytes.is_empty()) {
    const std::uint32_t length = bytes.number(4);
    require(length <= 0x7FFFFFFF, "a chunk is too long");
    Chunk chunk{bytes.take(4), bytes.take(length)};
    require(bytes.number(4) == crc32_of(std::string(chunk.name).append(chunk.data)),
            "wrong checksum of " + std::string(chunk.name));
    chunks.push_back(chunk);
  }
  return chunks;
}

std::string inflated(const std::string& data, std::size_t size) {
  std::string bytes(size + 1, '\0');  // one more would show
  z_stream stream{};
  require(inflateInit(&stream) == Z_OK, "no memory");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));  // only read
  stream.avail_in = static_cast<uInt>(data.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  const int result = inflate(&stream, Z_FINISH);
  const bool is_exact = result == Z_STREAM_END && stream.total_out == size && stream.avail_in == 0;
  inflateEnd(&stream);
  require(is_exact, "the compressed data are damaged, or more or less than the rectangle's");
  bytes.resize(size);
  return bytes;
}

int paeth(int a, int b, int c) {
  const int p = a + b - c;
  const int to_a = std::abs(p - a);
  const int to_b = std::abs(p - b);
  const int to_c = std::abs(p - c);
  if (to_a <= to_b && to_a <= to_c) return a;
  return to_b <= to_c ? b : c;
}

// Without the rows' filters.
std::vector<std::uint8_t> unfiltered(const std::string& rows, std::size_t width, std::size_t height,
                                     std::size_t channels) {
  const std::size_t length = width * channels;
  std::vector<std::uint8_t> pixels(length * height);
  for (std::size_t y = 0; y < height; ++y) {
    const int filter = static_cast<unsigned char>(rows[y * (length + 1)]);
    require(filter <= 4, "an unknown filter");
    for (std::size_t i = 0; i < length; ++i) {
      const int a = i >= channels ? pixels[y * length + i - channels] : 0;
      const int b = y > 0 ? pixels[(y - 1) * length + i] : 0;
      const int c = i >= channels && y > 0 ? pixels[(y - 1) * length + i - channels] : 0;
      const int by_filter[] = {0, a, b, (a + b) / 2, paeth(a, b, c)};
      const int raw = static_cast<unsigned char>(rows[y * (length + 1) + 1 + i]);
      pixels[y * length + i] = static_cast<std::uint8_t>(raw + by_filter[filter]);
    }
  }
  return pixels;
}

struct Control {
  std::uint32_t width, height, left, top;
  int delay_numerator, delay_denominator;
  int dispose, blend;
};

class Reader {
 public:
  Animation read(std::string_view file) {
    const std::vector<Chunk> chunks = chunks_of(file);
    require(!chunks.empty() && chunks.front().name == "IHDR", "the header is not the first chunk");
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      require((chunks[i].name == "IEND") == (i + 1 == chunks.size()), "IEND is not the last chunk, or not alone");
      require(i == 0 || chunks[i].name != "IHDR", "a second header");
      take(chunks[i]);
    }
    require(has_counts_, "no acTL");
    require(animation_.frames.size() == frames_, "another number of pictures than acTL says");
    return std::move(animation_);
  }

 private:
  void take(const Chunk& chunk) {
    const bool is_data = chunk.name == "IDAT" || chunk.name == "fdAT";
    if (!is_data) end_frame();
    Bytes data(chunk.data);
    if (chunk.name == "IHDR") {
      take_header(data);
    } else if (chunk.name == "acTL") {
      require(!has_counts_ && !has_picture_, "acTL twice, or after IDAT");
      has_counts_ = true;
      frames_ = data.number(4);
      animation_.plays = data.number(4);
      require(frames_ > 0, "no picture");
    } else if (chunk.name == "fcTL") {
      take_control(data);
    } else if (chunk.name == "IDAT") {
      require(!has_picture_ || is_in_picture_, "IDAT chunks that do not follow each other");
      has_picture_ = is_in_picture_ = true;
      compressed_ += data.rest();
    } else if (chunk.name == "fdAT") {
      require(has_picture_ && control_ && !is_in_picture_, "fdAT without its fcTL, or before IDAT");
      take_sequence_number(data);
      compressed_ += data.rest();
    } else if (chunk.name == "iTXt") {
      take_text(data);
    } else {
      require(chunk.name == "IEND" || (chunk.name[0] & 0x20) != 0, "an unknown critical chunk");
      data.rest();
    }
    require(data.is_empty(), std::string(chunk.name) + " is too long");
  }

  void take_header(Bytes& data) {
    width_ = data.number(4);
    height_ = data.number(4);
    require(width_ > 0 && height_ > 0 && data.number(1) == 8, "no size, or not eight bits");
    const std::uint32_t type = data.number(1);
    require(type == 2 || type == 6, "another colour type");
    channels_ = type == 6 ? 4 : 3;
    require(data.number(3) == 0, "another compression, filter or interlacing");
    canvas_.assign(std::size_t{4} * width_ * height_, 0);
  }

  void take_sequence_number(Bytes& data) { require(data.number(4) == sequence_++, "a sequence number is wrong"); }

  void take_control(Bytes& data) {
    require(has_counts_ && !control_, "fcTL without acTL, or twice");
    take_sequence_number(data);
    Control control{};
    control.width = data.number(4);
    control.height = data.number(4);
    control.left = data.number(4);
    control.top = data.number(4);
    control.delay_numerator = static_cast<int>(data.number(2));
    control.delay_denominator = static_cast<int>(data.number(2));
    control.dispose = static_cast<int>(data.number(1));
    control.blend = static_cast<int>(data.number(1));
    require(control.width > 0 && control.height > 0, "an empty rectangle");
    require(
        std::uint64_t{control.left} + control.width <= width_ && std::uint64_t{control.top} + control.height <= height_,
        "a rectangle reaches out of the picture");
    require(control.dispose <= 2 && control.blend <= 1, "an unknown way to put or to leave a picture");
    require(has_picture_ || (control.width == width_ && control.height == height_), "the first picture is not whole");
    control_ = control;
  }

  void take_text(Bytes& data) {
    require(data.until_zero() == "Description", "another keyword");
    require(data.number(2) == 0, "a compressed text");
    data.until_zero();
    data.until_zero();
    animation_.comment = data.rest();
  }

  // What has been collected is a picture now.
  void end_frame() {
    if (compressed_.empty()) return;
    is_in_picture_ = false;
    const Control control = control_.value_or(Control{width_, height_, 0, 0, 0, 0, 0, 0});
    const std::size_t length = std::size_t{control.width} * channels_ + 1;
    const std::vector<std::uint8_t> pixels =
        unfiltered(inflated(compressed_, length * control.height), control.width, control.height, channels_);
    compressed_.clear();
    if (!control_) return;  // a picture for programs that know no animation
    control_.reset();
    const std::vector<std::uint8_t> before = canvas_;
    draw(control, pixels);
    animation_.frames.push_back({seen(), control.left, control.top, control.width, control.height,
                                 control.delay_numerator, control.delay_denominator});
    if (control.dispose == 1)
      draw({.width = control.width,
            .height = control.height,
            .left = control.left,
            .top = control.top,
            .delay_numerator = 0,
            .delay_denominator = 0,
            .dispose = 0,
            .blend = 0},
           std::vector<std::uint8_t>(pixels.size(), 0));
    if (control.dispose == 2) canvas_ = before;
  }

  void draw(const Control& control, const std::vector<std::uint8_t>& pixels) {
    for (std::uint32_t y = 0; y < control.height; ++y) {
      for (std::uint32_t x = 0; x < control.width; ++x) {
        const std::uint8_t* from = &pixels[(std::size_t{y} * control.width + x) * channels_];
        std::uint8_t* to = &canvas_[(std::size_t{control.top + y} * width_ + control.left + x) * 4];
        const int alpha = channels_ == 4 ? from[3] : 255;
        require(control.blend == 0 || alpha == 0 || alpha == 255, "half transparent pixels are not for this reader");
        if (control.blend == 1 && alpha == 0) continue;
        for (int i = 0; i < 3; ++i) to[i] = from[i];
        to[3] = static_cast<std::uint8_t>(alpha);
      }
    }
  }

  Image seen() const {
    Image image{static_cast<int>(width_), static_cast<int>(height_), {}};
    bool is_opaque = true;
    for (std::size_t i = 0; i < canvas_.size(); i += 4) {
      image.rgb.insert(image.rgb.end(), &canvas_[i], &canvas_[i] + 3);
      image.alpha.push_back(canvas_[i + 3]);
      is_opaque = is_opaque && canvas_[i + 3] == 255;
    }
    if (is_opaque) image.alpha.clear();
    return image;
  }

  Animation animation_;
  std::uint32_t width_ = 0;
  std::uint32_t height_ = 0;
  std::size_t channels_ = 0;
  std::uint32_t frames_ = 0;
  std::uint32_t sequence_ = 0;
  bool has_counts_ = false;
  bool has_picture_ = false;    // IDAT
  bool is_in_picture_ = false;  // the newest chunk was one of it
  std::optional<Control> control_;
  std::string compressed_;
  std::vector<std::uint8_t> canvas_;  // red, green, blue, alpha
};

}  // namespace

Animation read_animated_png(std::string_view bytes) {
  return Reader().read(bytes);
}

}  // namespace ghostforce
