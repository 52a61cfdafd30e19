#include "dataset/internal/bag_chunk.hpp"

#include <bzlib.h>
#include <lz4frame.h>

#include <memory>
#include <vector>

#include "core/result.hpp"

namespace amiss::dataset {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 16U;

[[noreturn]] void refuse(const std::string& name, std::string_view compression) {
  throw InputError(name + ": a chunk is no whole " + std::string(compression) + " data of the size that it promises");
}

std::string from_bz2(std::string_view packed, std::size_t size, const std::string& name) {
  std::vector<char> in(packed.begin(), packed.end()), piece(kPiece);  // bzlib's input is not const
  bz_stream stream{};
  if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) throw std::runtime_error("bzlib cannot be used");
  const std::unique_ptr<bz_stream, int (*)(bz_stream*)> end(&stream, BZ2_bzDecompressEnd);
  stream.next_in = in.data();
  stream.avail_in = static_cast<unsigned>(in.size());
  std::string out;
  int status = BZ_OK;
  while (status == BZ_OK && out.size() <= size) {
    stream.next_out = piece.data();
    stream.avail_out = static_cast<unsigned>(piece.size());
    status = BZ2_bzDecompress(&stream);
    const std::size_t got = piece.size() - stream.avail_out;
    if (status == BZ_OK && got == 0 && stream.avail_in == 0) break;  // it ends too early
    out.append(piece.data(), got);
  }
  if (status != BZ_STREAM_END || out.size() != size) refuse(name, "bz2");
  return out;
}

std::string from_lz4(std::string_view packed, std::size_t size, const std::string& name) {
  LZ4F_dctx* raw = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION)) != 0U) {
    throw std::runtime_error("lz4 cannot be used");
  }
  const std::unique_ptr<LZ4F_dctx, std::size_t (*)(LZ4F_dctx*)> context(raw, LZ4F_freeDecompressionContext);
  std::vector<char> piece(kPiece);
  std::string out;
  std::size_t hint = 1;
  while (hint != 0 && out.size() <= size) {
    std::size_t taken = packed.size(), made = piece.size();
    hint = LZ4F_decompress(context.get(), piece.data(), &made, packed.data(), &taken, nullptr);
    if (LZ4F_isError(hint) != 0U || (taken == 0 && made == 0)) refuse(name, "lz4");
    packed.remove_prefix(taken);
    out.append(piece.data(), made);
  }
  if (out.size() != size) refuse(name, "lz4");
  return out;
}

}  // namespace

std::string chunk_expanded(std::string_view packed, std::string_view compression, std::size_t size,
                           const std::string& name) {
  if (compression == "bz2") return from_bz2(packed, size, name);
  if (compression == "lz4") return from_lz4(packed, size, name);
  if (compression != "none") {
    throw InputError(name + ": a chunk is compressed by '" + std::string(compression.substr(0, 20)) +
                     "'; none, bz2 and lz4 are allowed");
  }
  if (packed.size() != size) refuse(name, "plain");
  return std::string(packed);
}

}  // namespace amiss::dataset
