#!/usr/bin/env python3
"""Writes bags of a robot with a camera, to measure the memory that reading them takes: make_camera_bags.py GIGABYTES FOLDER
makes camera.mcap, camera_zstd.mcap and camera.db3 there, of joint states at 100 Hz and pictures that fill the rest
(docs/explanation/formats.md). Needs nothing but Python and libzstd."""
import ctypes
import ctypes.util
import pathlib
import random
import sqlite3
import struct
import sys
import zlib

import make_big
from make_bags import BEGIN, JOINT_STATE, PERIOD, Cdr, joint_state, record, text

HEADER = JOINT_STATE[JOINT_STATE.index("=" * 80):]
IMAGE = "std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\nuint8 is_bigendian\nuint32 step\nuint8[] data\n" + HEADER
TOPICS = [("/joint_states", "sensor_msgs/msg/JointState", JOINT_STATE), ("/camera/image_raw", "sensor_msgs/msg/Image", IMAGE)]
WIDTH, HEIGHT = 640, 480
STATES_PER_PICTURE = 25
PICTURES_PER_CHUNK = 4


def pictures():
    """Contents that a compressor halves, as it does with pictures of a dark room."""
    random.seed(4)
    size = 3 * WIDTH * HEIGHT
    mask = int.from_bytes(b"\x0f" * size, "little")
    return [(random.getrandbits(8 * size) & mask).to_bytes(size, "little") for _ in range(16)]


def image(time, content):
    cdr = Cdr().put("i", time // 10**9).put("I", time % 10**9).text("camera").put("I", HEIGHT).put("I", WIDTH)
    cdr.text("rgb8").put("B", 0).put("I", 3 * WIDTH).put("I", len(content))
    return cdr.bytes() + content


def messages(count):
    """(topic, time, content) of `count` pictures with the joint states between them."""
    contents = pictures()
    for p in range(count):
        for i in range(p * STATES_PER_PICTURE, (p + 1) * STATES_PER_PICTURE):
            time = BEGIN + round(1e9 * PERIOD * i)
            yield 1, time, joint_state(time, make_big.JOINTS, make_big.sample(i))
        yield 2, time, image(time, contents[p % len(contents)])


def compressed(content):
    zstd = ctypes.CDLL(ctypes.util.find_library("zstd") or "libzstd.so.1")
    zstd.ZSTD_compressBound.restype = zstd.ZSTD_compress.restype = ctypes.c_size_t
    zstd.ZSTD_compressBound.argtypes = [ctypes.c_size_t]
    zstd.ZSTD_compress.argtypes = [ctypes.c_char_p, ctypes.c_size_t, ctypes.c_char_p, ctypes.c_size_t, ctypes.c_int]
    room = ctypes.create_string_buffer(zstd.ZSTD_compressBound(len(content)))
    size = zstd.ZSTD_compress(room, len(room), content, len(content), 1)
    return room.raw[:size]


def chunk(part, compression):
    """A chunk of messages with its checksum."""
    content = b"".join(record(5, struct.pack("<HIQQ", topic, 0, time, time) + body) for topic, time, body in part)
    packed = compressed(content) if compression else content
    head = struct.pack("<QQQI", part[0][1], part[-1][1], len(content), zlib.crc32(content))
    return record(6, head + text(compression) + struct.pack("<Q", len(packed)) + packed)


def write_mcap(file, count, compression):
    known = b"".join(record(3, struct.pack("<H", n) + text(kind) + text("ros2msg") + text(definition)) +
                     record(4, struct.pack("<HH", n, n) + text(name) + text("cdr") + struct.pack("<I", 0))
                     for n, (name, kind, definition) in enumerate(TOPICS, 1))
    with open(file, "wb") as out:
        out.write(b"\x89MCAP0\r\n" + record(1, text("ros2") + text("make_camera_bags.py")) + known)
        part = []
        for message in messages(count):
            part.append(message)
            if message[0] == 2 and len(part) >= PICTURES_PER_CHUNK * (STATES_PER_PICTURE + 1):
                out.write(chunk(part, compression))
                part = []
        if part:
            out.write(chunk(part, compression))
        out.write(record(15, struct.pack("<I", 0)))
        summary = out.tell()
        counts = struct.pack("<HQHQ", 1, count * STATES_PER_PICTURE, 2, count)
        out.write(known + record(11, struct.pack("<QHIIIIQQ", count * (STATES_PER_PICTURE + 1), 2, 2, 0, 0, 0, 0, 0) +
                                 struct.pack("<I", len(counts)) + counts))
        out.write(record(2, struct.pack("<QQI", summary, 0, 0)) + b"\x89MCAP0\r\n")


def write_sqlite(file, count):
    file.unlink(missing_ok=True)
    bag = sqlite3.connect(file)
    bag.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
                "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL)")
    bag.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, "
                "data BLOB NOT NULL)")
    bag.executemany("INSERT INTO topics VALUES (?, ?, ?, 'cdr', '')",
                    [(n, name, kind) for n, (name, kind, _) in enumerate(TOPICS, 1)])
    bag.executemany("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)", messages(count))
    bag.commit()
    bag.close()


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    count, folder = round(float(sys.argv[1]) * 1e9 / (3 * WIDTH * HEIGHT)), pathlib.Path(sys.argv[2])
    write_mcap(folder / "camera.mcap", count, "")
    write_mcap(folder / "camera_zstd.mcap", count, "zstd")
    write_sqlite(folder / "camera.db3", count)
