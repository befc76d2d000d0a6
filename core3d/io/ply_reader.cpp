// SPDX-License-Identifier: MIT
#include <charconv>
#include <cmath>
#include <iterator>

#include "core3d/io/binary_bytes.h"
#include "core3d/io/ply_header.h"
#include "core3d/io/read_mesh.h"
#include "core3d/io/text_cursor.h"
#include "flatland/io/input_error.h"

namespace flatland {

namespace {

// A whole number of any size, also one that no integer type holds.
std::string wholeText(double whole) {
  char text[32];
  return {text, std::to_chars(text, std::end(text), whole, std::chars_format::fixed).ptr};
}

// The data of a text file: one element a line.
class AsciiData {
 public:
  AsciiData(std::string_view bytes, const std::string& source, const PlyHeader& header)
      : text_(bytes.substr(header.bytes), source, {}, header.lines + 1) {}

  // A value takes two bytes: a digit and what ends it.
  bool canHold(const PlyElement& element) const {
    const std::size_t size = 2 * element.properties.size();
    return size == 0 || element.count <= (text_.bytesLeft() + 1) / size;
  }
  void begin() {
    if (!text_.nextLine()) text_.fail("the file ends too early");
  }
  void end() {
    if (const auto word = text_.word(); !word.empty()) {
      text_.fail("more values than the header announces: " + inQuotes(word));
    }
  }
  double value(PlyScalar type) {
    if (!isWhole(type)) return text_.number("a value");
    return static_cast<double>(text_.integer("a value"));
  }
  std::size_t length(PlyScalar) {
    const std::int64_t length = text_.integer("the length of a list");
    if (length < 0) text_.fail("the length of a list is negative");
    if (static_cast<std::uint64_t>(length) > text_.bytesLeft()) {
      text_.fail("a list of " + std::to_string(length) + " values is longer than the file");
    }
    return static_cast<std::size_t>(length);
  }
  // A value that is not used may be of any kind (colours are written as 255 and as 1.0).
  void skip(PlyScalar) {
    if (text_.word().empty()) text_.fail("a value is missing");
  }
  [[noreturn]] void fail(const std::string& reason) const { text_.fail(reason); }
  std::size_t unread() { return text_.nextLine() ? text_.bytesLeft() : 0; }

 private:
  TextCursor text_;
};

class BinaryData {
 public:
  BinaryData(std::string_view bytes, const std::string& source, const PlyHeader& header)
      : bytes_(bytes), source_(source), order_(*header.binary), at_(header.bytes) {}

  bool canHold(const PlyElement& element) const {
    std::size_t size = 0;
    for (const PlyProperty& p : element.properties) size += sizeOf(p.countType.value_or(p.type));
    return size == 0 || element.count <= (bytes_.size() - at_) / size;
  }
  void begin() {}
  void end() {}
  double value(PlyScalar type) {
    const char* here = take(sizeOf(type));
    switch (type) {
      case PlyScalar::Int8:
        return static_cast<signed char>(*here);
      case PlyScalar::UInt8:
        return static_cast<unsigned char>(*here);
      case PlyScalar::Int16:
        return loadAs<std::int16_t>(here, order_);
      case PlyScalar::UInt16:
        return loadAs<std::uint16_t>(here, order_);
      case PlyScalar::Int32:
        return loadAs<std::int32_t>(here, order_);
      case PlyScalar::UInt32:
        return loadAs<std::uint32_t>(here, order_);
      case PlyScalar::Float32:
        return loadAs<float>(here, order_);
      case PlyScalar::Float64:
        return loadAs<double>(here, order_);
    }
    return 0.0;
  }
  std::size_t length(PlyScalar type) {
    const double length = value(type);
    if (length < 0.0) fail("the length of a list is negative");
    if (length > static_cast<double>(bytes_.size() - at_)) {
      fail("a list of " + std::to_string(static_cast<std::uint64_t>(length)) +
           " values is longer than the file");
    }
    return static_cast<std::size_t>(length);
  }
  void skip(PlyScalar type) { take(sizeOf(type)); }
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(source_, "byte " + std::to_string(at_), reason);
  }
  std::size_t unread() const { return bytes_.size() - at_; }

 private:
  const char* take(std::size_t size) {
    if (bytes_.size() - at_ < size) fail("the file ends too early");
    const char* here = bytes_.data() + at_;
    at_ += size;
    return here;
  }

  std::string_view bytes_;
  const std::string& source_;
  std::endian order_;
  std::size_t at_;
};

template <typename Data>
class PlyReader {
 public:
  PlyReader(Data data, const PlyHeader& header) : data_(std::move(data)), header_(header) {}

  PolygonSoup read() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") vertices_ += element.count;
      if (element.name == "vertex" && (vertices_ >= 0xffffffffu || ++vertexElements_ > 1)) {
        data_.fail("there are too many vertices");
      }
    }
    if (vertexElements_ == 0) data_.fail("the header has no element 'vertex'");
    bool faces = false;
    for (const PlyElement& element : header_.elements) {
      if (!data_.canHold(element)) {
        data_.fail("the header says " + std::to_string(element.count) + " times '" + element.name +
                   "', more than the file can hold");
      }
      if (element.name == "vertex") {
        readVertices(element);
      } else if (element.name == "face" || element.name == "tristrips") {
        readFaces(element);
        faces = true;
      } else if (!element.properties.empty()) {
        for (std::uint64_t i = 0; i < element.count; ++i) walkRow(element, std::nullopt, kNothing);
      }
    }
    if (!faces) data_.fail("there are no faces: a cloud of points is no mesh");
    if (soup_.corners.empty()) data_.fail("there are no faces");
    if (thin_ > 0) {
      soup_.notes.push_back(std::to_string(thin_) + (thin_ == 1 ? " face" : " faces") +
                            " with less than three corners left out");
    }
    if (const std::size_t rest = data_.unread(); rest > 0) {
      soup_.notes.push_back(std::to_string(rest) + " bytes after the last element passed over");
    }
    return std::move(soup_);
  }

 private:
  // For walkRow: takes no single value.
  static constexpr auto kNothing = [](std::size_t, PlyScalar) { return false; };

  // Goes through the values of one element. `take` may take single values: it gets the place of the
  // property and says whether it did. The values of the list `wanted` go to list_.
  template <typename Take>
  void walkRow(const PlyElement& element, std::optional<std::size_t> wanted, const Take& take) {
    data_.begin();
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      if (property.countType) {
        const std::size_t length = data_.length(*property.countType);
        if (wanted == i) {
          list_.clear();
          for (std::size_t k = 0; k < length; ++k) list_.push_back(data_.value(property.type));
        } else {
          for (std::size_t k = 0; k < length; ++k) data_.skip(property.type);
        }
      } else if (!take(i, property.type)) {
        data_.skip(property.type);
      }
    }
    data_.end();
  }

  void readVertices(const PlyElement& element) {
    std::size_t place[3];
    const char* const names[3] = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto found = element.find(names[axis]);
      if (!found || element.properties[*found].countType) {
        data_.fail(std::string("vertices have no ") + names[axis]);
      }
      place[axis] = *found;
    }
    soup_.positions.resize(3 * element.count);
    for (std::uint64_t v = 0; v < element.count; ++v) {
      double* position = &soup_.positions[3 * v];
      walkRow(element, std::nullopt, [&](std::size_t i, PlyScalar type) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          if (i != place[axis]) continue;
          position[axis] = data_.value(type);
          if (!std::isfinite(position[axis])) {
            data_.fail(std::string(names[axis]) + " of vertex " + std::to_string(v) +
                       " is not finite");
          }
          return true;
        }
        return false;
      });
    }
  }

  void readFaces(const PlyElement& element) {
    if (element.count == 0) return;
    auto list = element.find("vertex_indices");
    if (!list) list = element.find("vertex_index");
    if (!list || !element.properties[*list].countType || !isWhole(element.properties[*list].type)) {
      data_.fail("'" + element.name + "' has no list of whole numbers 'vertex_indices'");
    }
    const bool strips = element.name == "tristrips";
    if (!strips && soup_.ends.empty()) soup_.corners.reserve(3 * element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      walkRow(element, list, kNothing);
      corners_.clear();
      for (const double index : list_) {
        if (strips && index == -1.0) {
          soup_.addStrip(corners_);
          corners_.clear();
          continue;
        }
        if (!(index >= 0.0 && index < static_cast<double>(vertices_))) {
          data_.fail("'" + element.name + "' " + std::to_string(i) + " uses vertex " +
                     wholeText(index) + ", but they are 0 to " +
                     std::to_string(static_cast<std::int64_t>(vertices_) - 1));
        }
        corners_.push_back(static_cast<std::uint32_t>(index));
      }
      if (strips) {
        soup_.addStrip(corners_);
      } else if (corners_.size() < 3) {
        ++thin_;
      } else {
        soup_.addPolygon(corners_);
      }
    }
  }

  Data data_;
  const PlyHeader& header_;
  PolygonSoup soup_;
  std::uint64_t vertices_ = 0;
  int vertexElements_ = 0;
  std::vector<double> list_;
  std::vector<std::uint32_t> corners_;
  std::size_t thin_ = 0;
};

}  // namespace

PolygonSoup readPly(std::string_view bytes, const std::string& source) {
  const PlyHeader header = readPlyHeader(bytes, source);
  if (header.binary) return PlyReader(BinaryData(bytes, source, header), header).read();
  return PlyReader(AsciiData(bytes, source, header), header).read();
}

}  // namespace flatland
