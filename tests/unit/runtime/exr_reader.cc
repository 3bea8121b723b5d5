// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/runtime/exr_reader.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>
#include <string.h>

#include <stdexcept>

namespace texgraph::runtime {
namespace {

class MemoryStream : public Imf::IStream {
 public:
  explicit MemoryStream(const std::string& bytes) : Imf::IStream("memory"), bytes_(bytes) {}
  bool read(char to[], int count) override {
    if (at_ + static_cast<uint64_t>(count) > bytes_.size())
      throw std::runtime_error("read beyond the end");
    memcpy(to, bytes_.data() + at_, static_cast<size_t>(count));
    at_ += static_cast<uint64_t>(count);
    return at_ < bytes_.size();
  }
  uint64_t tellg() override { return at_; }
  void seekg(uint64_t at) override { at_ = at; }

 private:
  const std::string& bytes_;
  uint64_t at_ = 0;
};

}  // namespace

ExrFile ReadExr(const std::string& bytes) {
  MemoryStream stream(bytes);
  Imf::InputFile file(stream);
  ExrFile read;
  const Imath::Box2i box = file.header().dataWindow();
  EXPECT_EQ(box.min.x, 0);
  EXPECT_EQ(box.min.y, 0);
  EXPECT_EQ(file.header().displayWindow(), box);
  EXPECT_TRUE(file.isComplete());
  read.width = box.max.x + 1;
  read.height = box.max.y + 1;
  const Imf::ChannelList& list = file.header().channels();
  Imf::FrameBuffer frame;
  for (auto i = list.begin(); i != list.end(); ++i) {
    read.channels += i.name();
    read.type = i.channel().type;
    read.planes.emplace_back(static_cast<size_t>(read.width) * static_cast<size_t>(read.height));
  }
  size_t plane = 0;
  for (auto i = list.begin(); i != list.end(); ++i) {
    frame.insert(i.name(),
                 Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(read.planes[plane++].data()),
                            sizeof(float), sizeof(float) * static_cast<size_t>(read.width)));
  }
  file.setFrameBuffer(frame);
  file.readPixels(0, read.height - 1);
  return read;
}

}  // namespace texgraph::runtime
