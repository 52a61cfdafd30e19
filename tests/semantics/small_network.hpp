// The bytes of a small ONNX network, written here field by field: a 1 x 1 convolution of the colour channels.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace amiss::semantics::test {

/// Protocol buffers: a field of varint or of bytes.
class Message {
 public:
  Message& number(unsigned field, std::uint64_t value) {
    varint(field << 3U);
    varint(value);
    return *this;
  }
  Message& bytes(unsigned field, const std::string& value) {
    varint(field << 3U | 2U);
    varint(value.size());
    out_ += value;
    return *this;
  }
  Message& message(unsigned field, const Message& value) { return bytes(field, value.out_); }
  [[nodiscard]] const std::string& str() const { return out_; }

 private:
  void varint(std::uint64_t value) {
    while (value >= 0x80U) {
      out_ += static_cast<char>(value | 0x80U);
      value >>= 7U;
    }
    out_ += static_cast<char>(value);
  }
  std::string out_;
};

inline Message tensor(const std::string& name, const std::vector<std::uint64_t>& shape,
                      const std::vector<float>& data) {
  std::string raw(data.size() * sizeof(float), '\0');
  std::memcpy(raw.data(), data.data(), raw.size());
  Message message;
  for (const std::uint64_t edge : shape) message.number(1, edge);
  return message.number(2, 1).bytes(8, name).bytes(9, raw);
}

inline Message value(const std::string& name, const std::vector<std::uint64_t>& shape) {
  Message dims;
  for (const std::uint64_t edge : shape) dims.message(1, Message().number(1, edge));
  const Message of_floats = Message().number(1, 1).message(2, dims);
  return Message().bytes(1, name).message(2, Message().message(1, of_floats));
}

/// Scores of three classes: how red, how green and how blue a pixel is.
inline std::string colour_network(std::uint64_t width, std::uint64_t height) {
  const Message node = Message()
                           .bytes(1, "image")
                           .bytes(1, "weights")
                           .bytes(1, "bias")
                           .bytes(2, "scores")
                           .bytes(3, "convolution")
                           .bytes(4, "Conv")
                           .message(5, Message().bytes(1, "kernel_shape").number(8, 1).number(8, 1).number(20, 7));
  const Message graph = Message()
                            .message(1, node)
                            .bytes(2, "colours")
                            .message(5, tensor("weights", {3, 3, 1, 1}, {1, 0, 0, 0, 1, 0, 0, 0, 1}))
                            .message(5, tensor("bias", {3}, {0, 0, 0}))
                            .message(11, value("image", {1, 3, height, width}))
                            .message(12, value("scores", {1, 3, height, width}));
  return Message().number(1, 7).message(8, Message().bytes(1, "").number(2, 11)).message(7, graph).str();
}

}  // namespace amiss::semantics::test
