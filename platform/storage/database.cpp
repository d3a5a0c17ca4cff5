namespace lacuna {}
